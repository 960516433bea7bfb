// SPDX-License-Identifier: Apache-2.0
#include "window/hint_line.h"

#include <QResizeEvent>

namespace vs::desktop {

namespace {
constexpr int kPadding = 13; // of the hint's style
} // namespace

HintLine::HintLine() {
    setMinimumWidth(1); // never widens the window
}

void HintLine::say(const QString& hint) {
    setText(hint);
    setToolTip(hint);
}

void HintLine::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    const bool isNarrow = event->size().width() < kRoomForHints;
    setWordWrap(isNarrow);
    setFixedHeight(fontMetrics().lineSpacing() * (isNarrow ? 2 : 1) + kPadding);
}

} // namespace vs::desktop
