// SPDX-License-Identifier: Apache-2.0
#include "tool_panel.h"

#include "camera_tool.h"
#include "drill_tool.h"
#include "panel_parts.h"
#include "peel_tool.h"
#include "seed_tool.h"
#include "studio_controller.h"

#include <QFormLayout>
#include <QProgressBar>
#include <QSlider>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <cmath>

namespace vs::desktop {

namespace {

QFormLayout* makeForm(QWidget* page) {
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(12);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

// A slider with its value beside it.
template <typename Format>
QWidget* withValue(QSlider* slider, Format format) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    auto* value = new QLabel(format(slider->value()));
    value->setMinimumWidth(46);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(slider, 1);
    row->addWidget(value);
    QObject::connect(slider, &QSlider::valueChanged, value,
                     [value, format](int v) { value->setText(format(v)); });
    return holder;
}

QSlider* makeSlider(const char* objectName, const QString& accessibleName, int lo, int hi, int value) {
    auto* slider = named(new QSlider(Qt::Horizontal), objectName, accessibleName);
    slider->setRange(lo, hi);
    slider->setValue(value);
    return slider;
}

} // namespace

ToolPanel::ToolPanel(StudioController& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    auto* frame = makeCard(tr("Tool"), card);
    outer->addWidget(frame);
    title_ = frame->findChild<QLabel*>("cardTitle");
    pages_ = new QStackedWidget;
    auto* camera = makeQuietLabel(tr("Drag in the picture to turn the volume."));
    camera->setWordWrap(true);
    camera->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    pages_->addWidget(camera); // in the order of refresh()
    pages_->addWidget(makePeelPage());
    pages_->addWidget(makeDrillPage());
    pages_->addWidget(makeSeedPage());
    card->addWidget(pages_);
    connect(&studio_, &StudioController::changed, this, &ToolPanel::refresh);
    refresh();
}

QWidget* ToolPanel::makePeelPage() {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    layers_ = named(new QLabel, "peelLayers", tr("Layers peeled"));
    layers_->setAlignment(Qt::AlignRight);
    form->addRow(tr("Layers peeled"), layers_);
    auto* note =
        makeQuietLabel(tr("10 pixels of dragging are one layer; a layer is the smallest voxel spacing."));
    note->setWordWrap(true);
    form->addRow(note);
    const auto show = [this] { layers_->setText(QString::number(studio_.peelTool().layers(), 'f', 1)); };
    connect(&studio_.peelTool(), &PeelTool::layersChanged, this, show);
    show();
    return page;
}

QWidget* ToolPanel::makeDrillPage() {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    auto& drill = studio_.drillTool();
    constexpr int kPerStep = 2; // half steps
    auto* depth = makeSlider("drillDepth", tr("Depth of the drill at full pressure, in steps"),
                             int(kPerStep * DrillTool::kLeastDepth), int(kPerStep * DrillTool::kMostDepth),
                             int(std::lround(kPerStep * drill.depth())));
    connect(depth, &QSlider::valueChanged, this, [&drill](int v) { drill.setDepth(double(v) / kPerStep); });
    form->addRow(tr("Depth"),
                 withValue(depth, [](int v) { return tr("%1").arg(double(v) / kPerStep, 0, 'f', 1); }));

    auto* mouse = makeSlider("mousePressure", tr("Pressure of the mouse, in percent"), 5, 100, 100);
    mouse->setToolTip(tr("How hard the mouse presses; a tablet's pen reports its own pressure"));
    connect(mouse, &QSlider::valueChanged, this, [this](int v) { studio_.setMousePressure(v / 100.0); });
    form->addRow(tr("Mouse pressure"), withValue(mouse, [](int v) { return tr("%1 %").arg(v); }));

    pressure_ = named(new QProgressBar, "penPressure", tr("Pressure of the tablet's pen"));
    pressure_->setRange(0, 100);
    pressure_->setValue(0); // or its text is not shown
    pressure_->setFormat(tr("no tablet pen yet"));
    connect(&studio_, &StudioController::tabletPressureChanged, this, [this](double p) {
        pressure_->setFormat("%p %");
        pressure_->setValue(int(std::lround(100 * p)));
    });
    form->addRow(tr("Pen pressure"), pressure_);
    return page;
}

QWidget* ToolPanel::makeSeedPage() {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    auto& seed = studio_.seedTool();
    auto* width =
        makeSlider("seedWidth", tr("Width of the seed stroke, in pixels"), 1, 30, int(seed.width()));
    connect(width, &QSlider::valueChanged, this, [&seed](int v) { seed.setWidth(v); });
    form->addRow(tr("Stroke width"), withValue(width, [](int v) { return tr("%1 px").arg(v); }));
    return page;
}

void ToolPanel::refresh() {
    const Tool* tool = &studio_.tool();
    if (tool == &studio_.peelTool()) {
        title_->setText(tr("Peel"));
        pages_->setCurrentIndex(1);
    } else if (tool == &studio_.drillTool()) {
        title_->setText(tr("Drill"));
        pages_->setCurrentIndex(2);
    } else if (tool == &studio_.seedTool()) {
        title_->setText(tr("Seed"));
        pages_->setCurrentIndex(3);
    } else {
        title_->setText(tr("Camera"));
        pages_->setCurrentIndex(0);
    }
}

} // namespace vs::desktop
