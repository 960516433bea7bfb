// SPDX-License-Identifier: Apache-2.0
#include "panels/history_panel.h"

#include "model/studio/studio_controller.h"
#include "model/texts/operation_texts.h"
#include "parts/icons.h"
#include "parts/panel_parts.h"
#include "parts/theme.h"
#include "studio/document/document_facts.h"

#include <QEvent>
#include <QListWidget>

namespace vs::desktop {

HistoryPanel::HistoryPanel(StudioController& studio)
    : studio_(studio), travel_(studio.host(), studio.editor()),
      list_(named(new QListWidget, "historyList", tr("History"))) {
    named(this, "historyPanel", tr("History"));
    setWindowTitle(tr("History"));
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    list_->setUniformItemSizes(true);
    list_->setIconSize(QSize(18, 18));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumWidth(190);
    setWidget(list_);
    const auto go = [this](QListWidgetItem* item) { travel_.goTo(std::size_t(list_->row(item))); };
    connect(list_, &QListWidget::itemClicked, this, go);
    connect(list_, &QListWidget::itemActivated, this, go);
    connect(&studio_.host(), &DocumentHost::opened, this, [this] {
        seenOperations_ = 0;
        refresh();
    });
    connect(&studio_.host(), &DocumentHost::closed, list_, &QListWidget::clear);
    connect(&studio_.host(), &DocumentHost::changed, this, [this] {
        if (studio_.host().facts()->logged != seenOperations_) {
            refresh();
        }
    });
}

void HistoryPanel::showEvent(QShowEvent* event) {
    QDockWidget::showEvent(event);
    refresh();
}

void HistoryPanel::changeEvent(QEvent* event) {
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        refresh();
    }
}

void HistoryPanel::refresh() {
    if (studio_.host().geometry() == nullptr || !isVisible() || studio_.host().isReplaying()) {
        return; // looked at again when it is shown, or when the last operation is replayed
    }
    const auto facts = studio_.host().facts();
    seenOperations_ = facts->logged;
    const studio::Edits& edits = *facts->edits;
    list_->clear();
    addRow("open", tr("Opened"), true);
    for (std::size_t n = 0; n < edits.operations.size(); ++n) {
        const auto& operation = *edits.operations[n];
        addRow(iconName(operation), describe(operation), n < edits.done);
    }
    list_->setCurrentRow(int(edits.done));
    list_->scrollToItem(list_->currentItem());
}

void HistoryPanel::addRow(const char* iconName, const QString& text, bool holds) {
    const QIcon picture = icon(iconName);
    auto* row = new QListWidgetItem(
        holds ? picture : QIcon(picture.pixmap(list_->iconSize(), QIcon::Disabled)), text, list_);
    // The whole text, which the list may have no room for; as rich text, so that a long one gets lines.
    row->setToolTip(
        QString("<p>%1</p><p>%2</p>")
            .arg(text.toHtmlEscaped(), holds ? tr("Go back to after this") : tr("Do this again")));
    if (!holds) {
        row->setForeground(theme::kDisabled);
    }
}

} // namespace vs::desktop
