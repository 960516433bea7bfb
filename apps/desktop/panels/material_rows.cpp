// SPDX-License-Identifier: Apache-2.0
#include "panels/material_rows.h"

#include "model/studio/studio_controller.h"
#include "parts/colour_button.h"
#include "parts/panel_parts.h"
#include "studio/document/document.h"
#include "tools/kinds/cut_tool.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vs::desktop {

namespace {

using Material = studio::Material;

QColor colourOf(const Material& material) {
    return QColor::fromRgbF(float(material.colour.x), float(material.colour.y), float(material.colour.z));
}

// The material in hand and what can be done about it.
class MaterialRows : public QWidget {
public:
    MaterialRows(StudioController& studio, const QString& prefix) : studio_(studio) {
        const auto nameOf = [&](const char* what) { return (prefix + what).toLatin1(); };
        auto* form = new QFormLayout(this);
        form->setContentsMargins(0, 0, 0, 0);
        list_ = named(new QComboBox, nameOf("Material").constData(), CutTool::tr("Material to fill with"));
        auto* first = new QHBoxLayout;
        colour_ =
            new ColourButton(nameOf("MaterialColour").constData(), CutTool::tr("Colour of the material"));
        first->addWidget(list_, 1);
        first->addWidget(colour_);
        form->addRow(CutTool::tr("Material"), first);
        name_ = named(new QLineEdit, nameOf("MaterialName").constData(), CutTool::tr("Name of the material"));
        constexpr int mostLetters = 100;
        name_->setMaxLength(mostLetters);
        form->addRow(CutTool::tr("Name"), name_);
        value_ = makeSpinBox(nameOf("MaterialValue").constData(),
                             CutTool::tr("Intensity of the material, as the scan's values are"));
        value_->setRange(-1e9, 1e9);
        auto* second = new QHBoxLayout;
        second->addWidget(value_, 1);
        pick_ = named(new QPushButton(CutTool::tr("Pick")), nameOf("MaterialPick").constData(),
                      CutTool::tr("The next click on the picture takes the scan's value there"));
        pick_->setCheckable(true);
        pick_->setFocusPolicy(Qt::TabFocus);
        second->addWidget(pick_);
        form->addRow(CutTool::tr("Intensity"), second);
        visible_ = makeCheckBox(nameOf("MaterialVisible").constData(), CutTool::tr("Visible"),
                                CutTool::tr("Whether this material is seen"), true);
        remove_ = named(new QPushButton(CutTool::tr("Remove")), nameOf("MaterialRemove").constData(),
                        CutTool::tr("Takes all of this material away"));
        remove_->setFocusPolicy(Qt::TabFocus);
        segment_ = named(new QPushButton(CutTool::tr("To segment")), nameOf("MaterialSegment").constData(),
                         CutTool::tr("Adds what is filled with this material to the segment at work"));
        segment_->setFocusPolicy(Qt::TabFocus);
        auto* third = new QHBoxLayout;
        third->addWidget(visible_, 1);
        third->addWidget(segment_);
        third->addWidget(remove_);
        form->addRow(third);
        listen();
        show();
    }

    void show() {
        const studio::Materials materials = studio_.host().facts()->materials;
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const Material& material : *materials) {
            list_->addItem(QString::fromStdString(material.name));
        }
        const auto count = int(materials->size());
        if (count < field::kMostMaterials) {
            list_->addItem(CutTool::tr("New material"));
        }
        const int number = std::min(studio_.hand().material(), count + 1);
        list_->setCurrentIndex(number - 1);
        const bool exists = number <= count;
        for (QWidget* part :
             std::initializer_list<QWidget*>{name_, value_, pick_, visible_, remove_, colour_}) {
            part->setEnabled(exists);
        }
        remove_->setEnabled(exists && studio_.host().facts()->hasFill);
        segment_->setEnabled(exists && studio_.host().facts()->hasFill);
        pick_->setChecked(studio_.hand().picksValue());
        if (exists) {
            const Material& material = materials->at(std::size_t(number - 1));
            const QSignalBlocker quietValue(value_);
            const QSignalBlocker quietVisible(visible_);
            colour_->setColour(colourOf(material));
            if (!name_->hasFocus()) {
                name_->setText(QString::fromStdString(material.name));
            }
            value_->setDecimals(decimals());
            value_->setValue(material.value);
            visible_->setChecked(material.isVisible);
        } else {
            name_->clear();
        }
    }

private:
    // Floats: enough digits for a thousandth of the range.
    [[nodiscard]] int decimals() const {
        const auto& volume = studio_.host().document()->volume();
        const bool isWhole = volume.type != volume::ScalarType::Float32;
        const double width = std::max(volume.usual.width(), 1e-9);
        return isWhole ? 1 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8);
    }
    void listen() {
        connect(list_, &QComboBox::activated, this, [this](int n) {
            studio_.hand().setMaterial(n + 1);
            if (n == int(studio_.host().facts()->materials->size())) {
                studio_.editor().prepareMaterial();
            }
        });
        connect(colour_, &ColourButton::kept, this, [this](const QColor& colour) {
            change([&](auto& op) { op.colour = glm::dvec3(colour.redF(), colour.greenF(), colour.blueF()); });
        });
        connect(name_, &QLineEdit::editingFinished, this, [this] {
            const std::string name = name_->text().trimmed().toStdString();
            if (!name.empty()) {
                change([&](auto& op) { op.name = name; });
            }
        });
        connect(value_, &QDoubleSpinBox::valueChanged, this,
                [this](double value) { change([&](auto& op) { op.value = value; }); });
        connect(pick_, &QPushButton::toggled, this, [this](bool on) { studio_.hand().setPicksValue(on); });
        connect(visible_, &QCheckBox::toggled, this,
                [this](bool on) { change([&](auto& op) { op.isVisible = on; }); });
        connect(segment_, &QPushButton::clicked, this,
                [this] { studio_.editor().apply(studio::SegmentFill{studio_.hand().material()}); });
        connect(remove_, &QPushButton::clicked, this,
                [this] { studio_.editor().apply(studio::RemoveFill{studio_.hand().material()}); });
    }

    void change(const std::function<void(studio::SetMaterial&)>& set) {
        studio::SetMaterial op;
        op.number = studio_.hand().material();
        if (studio_.host().geometry() != nullptr &&
            op.number <= int(studio_.host().facts()->materials->size())) {
            set(op);
            studio_.editor().apply(op);
        }
    }

    StudioController& studio_;
    QComboBox* list_ = nullptr;
    ColourButton* colour_ = nullptr;
    QLineEdit* name_ = nullptr;
    QDoubleSpinBox* value_ = nullptr;
    QPushButton* pick_ = nullptr;
    QCheckBox* visible_ = nullptr;
    QPushButton* segment_ = nullptr;
    QPushButton* remove_ = nullptr;
};

} // namespace

void addMaterial(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix) {
    auto* rows = new MaterialRows(studio, prefix);
    form->addRow(rows);
    const auto show = [form, rows, &tool] {
        form->setRowVisible(rows, tool.actsOnMaterial());
        if (tool.actsOnMaterial()) {
            rows->show();
        }
    };
    QObject::connect(&studio.host(), &DocumentHost::changed, rows, show);
    QObject::connect(&studio.host(), &DocumentHost::opened, rows, show);
    show();
}

} // namespace vs::desktop
