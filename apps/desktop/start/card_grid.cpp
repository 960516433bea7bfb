// SPDX-License-Identifier: Apache-2.0
#include "start/card_grid.h"

#include "start/start_card.h"

#include <QKeyEvent>

#include <algorithm>

namespace vs::desktop {

void CardGrid::setCards(const std::vector<StartCard*>& cards) {
    for (StartCard* card : cards_) {
        card->hide();
        card->setObjectName({}); // now another's
        card->deleteLater();     // it may be what asked for this
    }
    cards_ = cards;
    for (StartCard* card : cards_) {
        card->setParent(this);
        card->show();
    }
    place();
}

int CardGrid::columns() const { return std::max(1, (width() + kGap) / (StartCard::kSize.width() + kGap)); }

void CardGrid::place() {
    const int perRow = columns();
    for (int n = 0; n < int(cards_.size()); ++n) {
        cards_[std::size_t(n)]->move((n % perRow) * (StartCard::kSize.width() + kGap),
                                     (n / perRow) * (StartCard::kSize.height() + kGap));
    }
    const int rows = (int(cards_.size()) + perRow - 1) / perRow;
    setFixedHeight(std::max(0, rows * (StartCard::kSize.height() + kGap) - kGap));
}

void CardGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) {
        place();
    }
}

void CardGrid::keyPressEvent(QKeyEvent* event) {
    const auto focused =
        std::find_if(cards_.begin(), cards_.end(), [](auto* card) { return card->hasFocus(); });
    const int step = event->key() == Qt::Key_Left    ? -1
                     : event->key() == Qt::Key_Right ? 1
                     : event->key() == Qt::Key_Up    ? -columns()
                     : event->key() == Qt::Key_Down  ? columns()
                                                     : 0;
    const auto next = (focused - cards_.begin()) + step;
    if (focused == cards_.end() || step == 0) {
        QWidget::keyPressEvent(event);
    } else if (next >= 0 && next < std::ssize(cards_)) {
        cards_[std::size_t(next)]->setFocus(Qt::TabFocusReason);
    } else {
        focusNextPrevChild(step > 0); // to the next group, or the one before
    }
}

} // namespace vs::desktop
