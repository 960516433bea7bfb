// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/cut_rows.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/clip_tool.h"
#include "tools/tool_box.h"

#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <cmath>

namespace vs::desktop {

namespace {

// A slider and a number for the same thing. Both count voxels, or millimetres.
struct Pair {
    QSlider* slider = nullptr;
    QSpinBox* number = nullptr;
    QWidget* row = nullptr;

    explicit Pair(const QString& name, const QString& text) {
        row = new QWidget;
        auto* layout = new QHBoxLayout(row);
        layout->setContentsMargins(0, 0, 0, 0);
        slider = makeSlider((name + "Slider").toLatin1().constData(), text, 0, 1, 0);
        number = named(new QSpinBox, name.toLatin1().constData(), text);
        number->setKeyboardTracking(false);
        number->setButtonSymbols(QAbstractSpinBox::NoButtons);
        number->setAlignment(Qt::AlignRight);
        number->setFixedWidth(54);
        QObject::connect(number, &QAbstractSpinBox::editingFinished, number, &QWidget::clearFocus);
        layout->addWidget(slider, 1);
        layout->addWidget(number);
    }

    // `take` is told the value and whether more will come.
    template <typename Take>
    void onChange(ClipTool& tool, Take take) const {
        QSlider* const s = slider;
        QObject::connect(slider, &QSlider::valueChanged, &tool,
                         [take, s](int v) { take(v, s->isSliderDown()); });
        QObject::connect(slider, &QSlider::sliderReleased, &tool, &ClipTool::finish);
        QObject::connect(number, &QSpinBox::valueChanged, &tool, [take](int v) { take(v, false); });
    }

    void show(int lo, int hi, int value) const {
        const QSignalBlocker blockSlider(slider);
        const QSignalBlocker blockNumber(number);
        slider->setRange(lo, hi);
        number->setRange(lo, hi);
        slider->setValue(value);
        number->setValue(value);
    }
};

// Faces are counted as voxels from the grid's low border.
void addFace(QFormLayout* form, ClipTool& tool, StudioController& studio, int axis, bool isHi) {
    const QString name = QString("clip%1%2").arg(isHi ? "Hi" : "Lo").arg(axis);
    const Pair face(name, tr("Face of the clip box, in voxels from the grid's border"));
    auto* label = new QLabel;
    label->setMinimumWidth(62);
    form->addRow(label, face.row);
    face.onChange(tool, [&tool, axis, isHi](int v, bool isDragged) {
        auto box = tool.box();
        const auto whole = tool.wholeBox();
        constexpr double kThinnest = 1; // voxel
        if (isHi) {
            box.hi[axis] = std::max(whole.lo[axis] + v, box.lo[axis] + kThinnest);
        } else {
            box.lo[axis] = std::min(whole.lo[axis] + v, box.hi[axis] - kThinnest);
        }
        tool.setBox(box, isDragged);
    });
    const auto show = [&tool, &studio, face, label, axis, isHi] {
        if (studio.host().geometry() == nullptr) {
            return;
        }
        const auto whole = tool.wholeBox();
        const auto box = tool.box();
        const double place = (isHi ? box.hi[axis] : box.lo[axis]) - whole.lo[axis];
        face.show(0, studio.host().geometry()->dims[axis], int(std::lround(place)));
        label->setText(ClipTool::directionOf(*studio.host().geometry(), axis, isHi));
    };
    QObject::connect(&tool, &ClipTool::clipChanged, label, show);
    QObject::connect(&studio.host(), &DocumentHost::corrected, label, show);
    show();
}

void addPlane(QFormLayout* form, ClipTool& tool) {
    auto* buttons = new QWidget;
    auto* layout = new QHBoxLayout(buttons);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* face = named(new QPushButton(tr("Face the viewer")), "clipPlaneFace",
                       tr("A clip plane that faces the viewer"));
    face->setToolTip(
        tr("Clips before a plane across the view; turn the volume and press again to turn it along"));
    auto* drop = named(new QPushButton(tr("No plane")), "clipPlaneDrop", tr("No clip plane"));
    for (auto* button : {face, drop}) {
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    QObject::connect(face, &QPushButton::clicked, &tool, &ClipTool::facePlane);
    QObject::connect(drop, &QPushButton::clicked, &tool, &ClipTool::dropPlane);
    form->addRow(buttons);
    const Pair offset("clipPlaneOffset", tr("Place of the clip plane before the centre, in mm"));
    offset.onChange(tool, [&tool](int v, bool isDragged) { tool.setPlaneOffset(v, isDragged); });
    form->addRow(tr("Plane"), offset.row);
    const auto show = [&tool, offset, drop] {
        const int most = int(std::ceil(tool.greatestOffset()));
        offset.show(-most, most, int(std::lround(tool.planeOffset())));
        offset.row->setEnabled(tool.hasPlane());
        drop->setEnabled(tool.hasPlane());
    };
    QObject::connect(&tool, &ClipTool::clipChanged, offset.row, show);
    show();
}

} // namespace

QWidget* makeClipPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    form->setVerticalSpacing(5);
    ClipTool& tool = tools.get<ClipTool>();
    addCutOrRestore(form, tool, studio, "clip");
    for (int axis = 0; axis < 3; ++axis) {
        addFace(form, tool, studio, axis, false);
        addFace(form, tool, studio, axis, true);
    }
    addPlane(form, tool);
    auto* side = new ChoiceRow(
        {{"clipOutside", tr("Outside"), tr("What is outside the box, or before the plane, goes")},
         {"clipInside", tr("Inside"), tr("What is inside goes instead")}},
        0);
    QObject::connect(side, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setCutsInside(n == 1); });
    QObject::connect(&tool, &ClipTool::clipChanged, side,
                     [&tool, side] { side->choose(tool.cutsInside() ? 1 : 0); });
    form->addRow(tr("Takes"), side);
    addRadius(form, tool, "clip");
    auto* reset = named(new QPushButton(tr("Reset")), "clipReset", tr("The whole grid again, no plane"));
    reset->setFocusPolicy(Qt::TabFocus);
    QObject::connect(reset, &QPushButton::clicked, &tool, &ClipTool::reset);
    form->addRow(reset);
    return page;
}

} // namespace vs::desktop
