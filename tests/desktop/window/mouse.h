// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio_window.h"

namespace vs::desktop {

// A mouse on the view, at places given in fractions of it: real events through the window.
class Mouse {
public:
    explicit Mouse(StudioWindow& window) : w_(window) {}

    void move(QPointF place);
    void press(QPointF place);
    void release(QPointF place);
    void click(QPointF place);
    void doubleClick(QPointF place);
    // Presses at the first place, goes through the others, lets go at the last.
    void drag(const std::vector<QPointF>& way);

private:
    [[nodiscard]] QPoint inWindow(QPointF place) const;

    StudioWindow& w_;
};

} // namespace vs::desktop
