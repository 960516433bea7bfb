// SPDX-License-Identifier: Apache-2.0
// Settings of the tools that work on segments.
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/island_tool.h"
#include "tools/seed_tool.h"
#include "tools/tool_box.h"

#include <QFormLayout>

namespace vs::desktop {

namespace {

// Two buttons for a tool's sign.
template <typename T>
void addSign(QFormLayout* form, T& tool, const ChoiceRow::Choice& plain, const ChoiceRow::Choice& reversed) {
    auto* sign = new ChoiceRow({plain, reversed}, tool.isReversed() ? 1 : 0);
    QObject::connect(sign, &ChoiceRow::chosen, &tool, [&tool](int n) { tool.setReversed(n == 1); });
    QObject::connect(&tool, &T::settingsChanged, sign,
                     [&tool, sign] { sign->choose(tool.isReversed() ? 1 : 0); });
    form->addRow(sign);
}

} // namespace

QWidget* makeSeedPage(StudioController&, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    SeedTool& tool = tools.get<SeedTool>();
    addSign(form, tool, {"seedSeeds", tr("Seed"), tr("Strokes are what the segment grows from (R)")},
            {"seedAbsorbs", tr("Absorb"), tr("Strokes take the segment away, from there outward (R)")});
    auto* width =
        makeSlider("seedWidth", tr("Width of the seed stroke, in pixels"), 1, 30, int(tool.width()));
    QObject::connect(width, &QSlider::valueChanged, &tool, [&tool](int v) { tool.setWidth(v); });
    form->addRow(tr("Stroke width"), withValue(width, [](int v) { return tr("%1 px").arg(v); }));
    return page;
}

QWidget* makeIslandPage(StudioController&, ToolBox& tools) {
    auto* page = new QWidget;
    auto* form = makeForm(page);
    addSign(form, tools.get<IslandTool>(),
            {"islandDrops", tr("Drop"), tr("What is connected to the place clicked goes (R)")},
            {"islandKeeps", tr("Keep only"), tr("What is not connected to the place clicked goes (R)")});
    return page;
}

} // namespace vs::desktop
