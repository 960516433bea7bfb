// SPDX-License-Identifier: Apache-2.0
#include "panels/tool_panel.h"

#include "model/studio/studio_controller.h"
#include "panels/tool_pages.h"
#include "parts/panel_parts.h"
#include "tools/camera_tool.h"
#include "tools/clip_tool.h"
#include "tools/drill_tool.h"
#include "tools/island_tool.h"
#include "tools/keep_tool.h"
#include "tools/laser_tool.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/paint_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/sweep_tool.h"
#include "tools/tool_box.h"

#include <QStyle>
#include <QVBoxLayout>

namespace vs::desktop {

ToolPanel::ToolPanel(StudioController& studio, ToolBox& tools, QWidget* parent)
    : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    auto* frame = makeCard(tr("Tool"), card);
    outer->addWidget(frame);
    title_ = frame->findChild<QLabel*>("cardTitle");
    pagesBelow_ = card;
    add(tools.camera(), tr("Camera"), makeCameraPage());
    add(tools.peel(), tr("Peel"), makePeelPage(studio_, tools));
    add(tools.drill(), tr("Drill"), makeDrillPage(studio_, tools));
    add(tools.laser(), tr("Laser"), makeLaserPage(studio_, tools));
    add(tools.sweep(), tr("Sweep"), makeSweepPage(studio_, tools));
    add(tools.scissors(), tr("Scissors"), makeScissorsPage(studio_, tools));
    add(tools.keep(), tr("Keep connected"), makeKeepPage(studio_, tools));
    add(tools.clip(), tr("Clip"), makeClipPage(studio_, tools));
    add(tools.seed(), tr("Seed"), makeSeedPage(studio_, tools));
    add(tools.island(), tr("Island"), makeIslandPage(studio_, tools));
    add(tools.measure(), tr("Measure"), makeMeasurePage(studio_, tools));
    add(tools.paint(), tr("Paint"), makePaintPage(studio_, tools));
    add(tools.move(), tr("Move part"), makeMovePage(studio_, tools));
    pressure_ = makePressureRows(studio_);
    card->addWidget(pressure_);
    connect(&studio_.host(), &DocumentHost::changed, this, &ToolPanel::refresh);
    refresh();
}

void ToolPanel::add(const Tool& tool, const QString& title, QWidget* page) {
    page->hide();
    pagesBelow_->addWidget(page);
    pages_[&tool] = {title, page};
}

void ToolPanel::refresh() {
    const Page& page = pages_.at(&studio_.hand().tool());
    if (shown_ != page.widget) {
        shown_ = page.widget;
        // Not a stack, which would be as high as the highest page.
        for (const auto& [tool, other] : pages_) {
            other.widget->setVisible(other.widget == page.widget);
        }
    }
    pressure_->setVisible(qobject_cast<const PenTool*>(&studio_.hand().tool()) != nullptr);
    const auto* cutTool = qobject_cast<CutTool*>(&studio_.hand().tool());
    const bool restores = cutTool != nullptr && cutTool->restores();
    const bool isOnSegment = cutTool != nullptr && cutTool->actsOnSegment();
    title_->setText(restores ? tr("%1: restore").arg(page.title)
                    : isOnSegment
                        ? (cutTool->adds() ? tr("%1: add to the segment") : tr("%1: remove from the segment"))
                              .arg(page.title)
                        : page.title);
    if (title_->property("restores").toBool() != restores) {
        title_->setProperty("restores", restores);
        title_->style()->unpolish(title_);
        title_->style()->polish(title_);
    }
}

} // namespace vs::desktop
