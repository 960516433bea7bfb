// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"
#include "mouse.h"

#include <functional>

namespace vs::desktop {

// Goes from state to state of the tools by hand in the window, and has each looked at.
class HintWalk {
public:
    using Look = std::function<void(const std::string& state)>;

    static inline const QPointF kA{0.46, 0.46};
    static inline const QPointF kB{0.54, 0.47};
    static inline const QPointF kC{0.5, 0.54};
    static inline const QPointF kMiddle{0.5, 0.49};

    HintWalk(StudioWindow& window, const Look& look) : w_(window), mouse_(window), look_(look) {}

    void choose(Tool& tool);
    void look(const std::string& state);
    // A shape that is dragged, up to where letting go would end it.
    void sketch(const std::string& tool, studio::Shape shape, const char* name);
    // Corner after corner, up to where letting go would close it; and what comes of that.
    void polyline(const std::string& tool);
    void closePolyline();
    void dropPolyline();
    void takeStencil();

protected:
    StudioWindow& w_;
    Mouse mouse_;

private:
    const Look& look_;
};

} // namespace vs::desktop
