// SPDX-License-Identifier: Apache-2.0
#include "panels/tool_panel.h"

#include "model/studio/studio_controller.h"
#include "panels/tool_pages.h"
#include "panels/tool_rows.h"
#include "parts/panel_parts.h"
#include "tools/kinds/cut_tool.h"
#include "tools/pen_tool.h"
#include "tools/play_tool.h"
#include "tools/tool_box.h"

#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

// The page of a tool for which nothing can be set.
QWidget* makeTipPage(const QString& tip) {
    auto* text = makeQuietLabel(tip);
    text->setWordWrap(true);
    return text;
}

} // namespace

ToolPanel::ToolPanel(StudioController& studio, ToolBox& tools, QWidget* parent)
    : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    auto* frame = makeCard(tr("Tool"), card);
    outer->addWidget(frame);
    title_ = frame->findChild<QLabel*>("cardTitle");
    pagesBelow_ = card;
    for (const ToolRow& row : toolRows(tools)) {
        QWidget* page = row.makePage != nullptr ? row.makePage(studio_, tools) : makeTipPage(row.tip);
        page->hide();
        pagesBelow_->addWidget(page);
        pages_[&row.tool] = {row.title, page};
    }
    // Which is taken by opening a session, not from the column of tools.
    QWidget* playing = makeTipPage(tr("The steps of the session are below the picture."));
    playing->hide();
    pagesBelow_->addWidget(playing);
    pages_[&tools.get<PlayTool>()] = {tr("Play"), playing};
    pressure_ = makePressureRows(studio_);
    card->addWidget(pressure_);
    connect(&studio_.host(), &DocumentHost::changed, this, &ToolPanel::refresh);
    refresh();
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
    const bool isOnMaterial = cutTool != nullptr && cutTool->actsOnMaterial();
    title_->setText(
        isOnMaterial ? (cutTool->isReversed() ? tr("%1: take material away") : tr("%1: fill")).arg(page.title)
        : restores   ? tr("%1: restore").arg(page.title)
        : isOnSegment ? (cutTool->adds() ? tr("%1: add to the segment") : tr("%1: remove from the segment"))
                            .arg(page.title)
                      : page.title);
    if (title_->property("restores").toBool() != restores) {
        title_->setProperty("restores", restores);
        title_->style()->unpolish(title_);
        title_->style()->polish(title_);
    }
}

} // namespace vs::desktop
