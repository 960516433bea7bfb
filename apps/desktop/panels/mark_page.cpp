// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/tool_pages.h"
#include "parts/colour_button.h"
#include "parts/panel_parts.h"
#include "tools/mark_tool.h"
#include "tools/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include <cmath>
#include <memory>

namespace vs::desktop {

namespace {

// The slider goes by equal factors, so that thin lines are as easy to set as thick ones.
constexpr int kWidths = 200;

int widthStep(double mm) {
    const double part = std::log(mm / MarkTool::kLeastMm) / std::log(MarkTool::kMostMm / MarkTool::kLeastMm);
    return int(std::lround(kWidths * part));
}

double widthAt(int step) {
    return MarkTool::kLeastMm * std::pow(MarkTool::kMostMm / MarkTool::kLeastMm, double(step) / kWidths);
}

QString percent(int value) { return tr("%1 %").arg(value); }

void addSignAndKind(QFormLayout* form, MarkTool& tool) {
    auto* sign = new ChoiceRow({{"markMarks", tr("Mark"), tr("The pen lays its colour on the material (R)")},
                                {"markErases", tr("Erase"), tr("The pen takes marks away (R)")}},
                               tool.isReversed() ? 1 : 0);
    QObject::connect(sign, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setReversed(n == 1); });
    QObject::connect(&tool, &MarkTool::settingsChanged, sign,
                     [&tool, sign] { sign->choose(tool.isReversed() ? 1 : 0); });
    form->addRow(sign);
    auto* kind =
        new ChoiceRow({{"markLine", tr("Line"), tr("A line along the shape that is drawn")},
                       {"markArea", tr("Area"), tr("What the shape encloses")},
                       {"markArrow", tr("Arrow"), tr("A line with a head at its end")},
                       {"markText", tr("Letters"), tr("Letters where one clicks, upright in the picture")}},
                      int(tool.kind()), 2);
    QObject::connect(kind, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setKind(MarkTool::Kind(n)); });
    form->addRow(tr("What"), kind);
}

void addColour(QFormLayout* form, MarkTool& tool) {
    auto* colour = new ColourButton("markColour", tr("Colour of the pen"));
    colour->setColour(tool.colour());
    const auto before = std::make_shared<QColor>(tool.colour());
    QObject::connect(colour, &ColourButton::asked, &tool, [&tool, before] { *before = tool.colour(); });
    QObject::connect(colour, &ColourButton::tried, &tool, [&tool](const QColor& c) { tool.setColour(c); });
    QObject::connect(colour, &ColourButton::dropped, &tool, [&tool, before] { tool.setColour(*before); });
    QObject::connect(&tool, &MarkTool::settingsChanged, colour,
                     [&tool, colour] { colour->setColour(tool.colour()); });
    form->addRow(tr("Colour"), colour);
    auto* opacity = makeSlider("markOpacity", tr("Opacity of the pen, in percent"), 5, 100,
                               int(std::lround(100 * tool.pen().opacity)));
    QObject::connect(opacity, &QSlider::valueChanged, &tool, [&tool](int v) { tool.setOpacity(v / 100.0); });
    form->addRow(tr("Opacity"), withValue(opacity, percent));
    auto* soft = makeSlider("markSoftness", tr("How much of the line is a soft rim, in percent"), 0, 100,
                            int(std::lround(100 * tool.softness())));
    QObject::connect(soft, &QSlider::valueChanged, &tool, [&tool](int v) { tool.setSoftness(v / 100.0); });
    form->addRow(tr("Soft rim"), withValue(soft, percent));
}

void addLine(QFormLayout* form, MarkTool& tool) {
    auto* width = makeSlider("markWidth", tr("Width of lines on the surface, in mm"), 0, kWidths,
                             widthStep(tool.pen().widthMm));
    QObject::connect(width, &QSlider::valueChanged, &tool, [&tool](int v) { tool.setWidthMm(widthAt(v)); });
    form->addRow(tr("Width"), withValue(width, [](int v) {
                     return tr("%1 mm").arg(widthAt(v), 0, 'f', widthAt(v) < 9.95 ? 1 : 0);
                 }));
    auto* dashed = makeCheckBox("markDashed", tr("Dashed"),
                                tr("Dashes three times as long as the line is wide"), tool.isDashed());
    QObject::connect(dashed, &QCheckBox::toggled, &tool, &MarkTool::setDashed);
    form->addRow(dashed);
    auto* pressure = new ChoiceRow(
        {{"markPressureWidth", tr("Width"), tr("A pen that is pressed less draws thinner lines")},
         {"markPressureOpacity", tr("Opacity"), tr("A pen that is pressed less draws paler lines")},
         {"markPressureNothing", tr("Nothing"), tr("Lines are the same however hard the pen is pressed")}},
        int(tool.pen().pressureSets));
    QObject::connect(pressure, &ChoiceRow::chosen, &tool,
                     [&tool](int n) { tool.setPressureSets(studio::Mark::Pressure(n)); });
    form->addRow(tr("Pressure"), pressure);
}

void addLetters(QFormLayout* form, MarkTool& tool) {
    auto* text = named(new QLineEdit(QString::fromStdString(tool.pen().text)), "markLetters",
                       tr("Letters that are written"));
    constexpr int mostLetters = 100;
    text->setMaxLength(mostLetters);
    QObject::connect(text, &QLineEdit::textChanged, &tool, &MarkTool::setText);
    form->addRow(tr("Letters"), text);
    auto* size =
        makeSlider("markSize", tr("Height of letters, in mm"), 2, 60, int(std::lround(tool.pen().sizeMm)));
    QObject::connect(size, &QSlider::valueChanged, &tool, [&tool](int v) { tool.setSizeMm(v); });
    auto* row = withValue(size, [](int v) { return tr("%1 mm").arg(v); });
    form->addRow(tr("Height"), row);
    const auto show = [form, text, row, &tool] {
        const bool isText = tool.kind() == MarkTool::Kind::Text;
        form->setRowVisible(text, isText);
        form->setRowVisible(row, isText);
    };
    QObject::connect(&tool, &MarkTool::settingsChanged, text, show);
    show();
}

} // namespace

QWidget* makeMarkPage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    MarkTool& tool = tools.get<MarkTool>();
    addSignAndKind(form, tool);
    addLetters(form, tool);
    addColour(form, tool);
    addLine(form, tool);
    auto* all = named(new QPushButton(tr("Remove all marks")), "markRemoveAll", tr("Take all marks away"));
    all->setFocusPolicy(Qt::TabFocus);
    form->addRow(all);
    QObject::connect(all, &QPushButton::clicked, &tool, &MarkTool::removeAll);
    const auto show = [all, &studio] { all->setEnabled(studio.host().facts()->hasMarks); };
    QObject::connect(&studio.host(), &DocumentHost::changed, all, show);
    QObject::connect(&studio.host(), &DocumentHost::opened, all, show);
    show();
    return page;
}

} // namespace vs::desktop
