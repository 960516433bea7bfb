// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/measure_tool.h"
#include "tools/tool_box.h"

#include "studio/editing/vessel_chart.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>

#include <algorithm>

namespace vs::desktop {

namespace {

// The diameters along the vessel that was measured last; nothing where none was.
void showCurve(QLabel& label, const MeasureTool& tool, StudioController& studio) {
    const auto& all = tool.measurements();
    const auto vessel =
        std::find_if(all.rbegin(), all.rend(), [](const auto& one) { return one.isVessel(); });
    label.setVisible(vessel != all.rend());
    if (vessel == all.rend()) {
        return;
    }
    const double ratio = label.devicePixelRatioF();
    const QSize size = QSize(248, 120) * ratio;
    const image::Image drawn =
        studio::vesselChart(*vessel, *studio.host().geometry(), {size.width(), size.height()}, ratio);
    QPixmap pixels = QPixmap::fromImage(QImage(drawn.rgba.data(), drawn.width, drawn.height,
                                               qsizetype(4) * drawn.width, QImage::Format_RGBA8888));
    pixels.setDevicePixelRatio(ratio);
    label.setPixmap(pixels);
}

} // namespace

QWidget* makeMeasurePage(StudioController& studio, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    MeasureTool& tool = tools.get<MeasureTool>();
    auto* what = new ChoiceRow(
        {{"measureDistance", tr("Distance"), tr("Between two places, in mm")},
         {"measureAngle", tr("Angle"), tr("At the second of three places, in degrees")},
         {"measurePath", tr("Path"), tr("Along a line that is drawn, in mm")},
         {"measureArea", tr("Area"),
          tr("Inside an outline that is drawn on a slice, with mean and spread of the values")},
         {"measureVessel", tr("Vessel"),
          tr("Between two places along a segment: its centreline, its diameters, the narrowest of them")}},
        int(tool.kind()), 2);
    QObject::connect(what, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setKind(MeasureTool::Kind(n)); });
    form->addRow(tr("Measure"), what);
    auto* values = named(new QLabel, "measurements", tr("What was measured"));
    values->setAlignment(Qt::AlignRight);
    values->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(tr("Values"), values);
    auto* curve = named(new QLabel, "vesselCurve", tr("Diameters along the vessel that was measured last"));
    form->addRow(curve);
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
    const auto show = [&studio, &tool, values, curve, last, all] {
        QStringList lines;
        for (const studio::Measured& measured : tool.measurements()) {
            lines << tool.labelOf(measured);
        }
        values->setText(lines.isEmpty() ? tr("none yet") : lines.join("\n"));
        showCurve(*curve, tool, studio);
        last->setEnabled(!lines.isEmpty());
        all->setEnabled(!lines.isEmpty());
    };
    QObject::connect(&tool, &MeasureTool::changed, values, show);
    show();
    return page;
}

} // namespace vs::desktop
