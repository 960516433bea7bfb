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
    auto* what = new ChoiceRow(
        {{"measureDistance", tr("Distance"), tr("Between two places, in mm")},
         {"measureAngle", tr("Angle"), tr("At the second of three places, in degrees")},
         {"measurePath", tr("Path"), tr("Along a line that is drawn, in mm")},
         {"measureArea", tr("Area"),
          tr("Inside an outline that is drawn on a slice, with mean and spread of the values")}},
        int(tool.kind()), 2);
    QObject::connect(what, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setKind(MeasureTool::Kind(n)); });
    form->addRow(tr("Measure"), what);
    auto* values = named(new QLabel, "measurements", tr("What was measured"));
    values->setAlignment(Qt::AlignRight);
    values->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(tr("Values"), values);
    auto* cut = named(new QPushButton(tr("Volume of what is cut")), "measureCut",
                      tr("Measure how much is cut away, in ml"));
    cut->setFocusPolicy(Qt::TabFocus);
    form->addRow(cut);
    QObject::connect(cut, &QPushButton::clicked, &tool, &MeasureTool::measureCut);
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
        for (const studio::Measured& measured : tool.measurements()) {
            lines << tool.labelOf(measured);
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
