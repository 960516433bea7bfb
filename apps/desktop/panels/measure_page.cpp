// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/measure_tool.h"
#include "tools/tool_box.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>

namespace vs::desktop {

QWidget* makeMeasurePage(StudioController&, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    MeasureTool& tool = tools.get<MeasureTool>();
    auto* what =
        new ChoiceRow({{"measureDistance", tr("Distance"), tr("Between two places, in mm")},
                       {"measureAngle", tr("Angle"), tr("At the second of three places, in degrees")}},
                      tool.measuresAngles() ? 1 : 0);
    QObject::connect(what, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setMeasuresAngles(n == 1); });
    form->addRow(tr("Measure"), what);
    auto* values = named(new QLabel, "measurements", tr("What was measured"));
    values->setAlignment(Qt::AlignRight);
    values->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(tr("Values"), values);
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    auto* last =
        named(new QPushButton(tr("Delete last")), "measureDeleteLast", tr("Delete the last measurement"));
    auto* all = named(new QPushButton(tr("Delete all")), "measureDeleteAll", tr("Delete all measurements"));
    for (QPushButton* button : {last, all}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    form->addRow(buttons);
    QObject::connect(last, &QPushButton::clicked, &tool, &MeasureTool::removeLast);
    QObject::connect(all, &QPushButton::clicked, &tool, &MeasureTool::removeAll);
    const auto show = [&tool, values, last, all] {
        QStringList lines;
        for (const Measurement& measurement : tool.measurements()) {
            lines << labelOf(measurement);
        }
        values->setText(lines.isEmpty() ? tr("none yet") : lines.join("\n"));
        last->setEnabled(!lines.isEmpty());
        all->setEnabled(!lines.isEmpty());
    };
    QObject::connect(&tool, &MeasureTool::changed, values, show);
    show();
    return page;
}

} // namespace vs::desktop
