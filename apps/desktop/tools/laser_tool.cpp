// SPDX-License-Identifier: Apache-2.0
#include "tools/laser_tool.h"

#include "model/studio/studio_controller.h"

#include "base/timer.h"
#include "studio/document/surface_queries.h"

#include <algorithm>

namespace vs::desktop {

namespace {
constexpr int kLayMs = 30; // not more often than a picture is shown
} // namespace

LaserTool::LaserTool(StudioController& studio) : PenTool(studio, {18, 22, 20}) {
    timer_.setSingleShot(true);
    timer_.setInterval(kLayMs);
    connect(&timer_, &QTimer::timeout, this, &LaserTool::lay);
}

MaskTool::Words LaserTool::words() const {
    const QString draw = tr("Draw the shape of the laser anywhere.");
    if (restores()) {
        return {draw,
                tr("The mask lies on the surface under the pen. Press and move to build it up again. Esc "
                   "clears it for a new shape."),
                tr("Building up: press harder for more. Let go to keep, Esc to undo.")};
    }
    return {draw,
            tr("The mask lies on the surface under the pen. Press and move to burn. Esc clears it for a new "
               "shape."),
            tr("Burning: press harder to go deeper. Let go to keep, Esc to undo.")};
}

studio::Operation LaserTool::operation(const studio::PenCut& cut) const {
    studio::Laser laser;
    static_cast<studio::PenCut&>(laser) = cut;
    return laser;
}

void LaserTool::press(const Pen& pen) {
    if (state() != State::Ready) {
        lying_ = {}; // that was another mask
    }
    PenTool::press(pen);
}

void LaserTool::hover(const Pen& pen) {
    PenTool::hover(pen);
    if (state() == State::Ready && !timer_.isActive()) {
        timer_.start();
    }
}

// How the mask lies on the surface now. While the picture moves there is no time for it.
void LaserTool::lay() {
    if (state() != State::Ready || !isPenOver()) {
        return;
    }
    if (!studio_.isSettled()) {
        timer_.start();
        return;
    }
    const Timer timer;
    const glm::dvec2 scale = studio_.view().devicePerLogical();
    const glm::dvec2 pixel = glm::dvec2(penPosition().x(), penPosition().y()) * scale;
    studio_.host().workLong([&] {
        lying_ = closedPath(studio_.host().document()->surface().outlineOnSurface(
                                pad().sketch(scale), pixel, studio_.picture().viewport()),
                            scale);
    });
    lyingAt_ = penPosition();
    // On a slow device seldom enough that the hand does not feel it.
    timer_.setInterval(std::clamp(int(3 * timer.milliseconds()), kLayMs, 500));
    emit overlayChanged();
}

// Between two looks it moves along as it is, and so it does while it burns: what it burns is not what it lies
// on.
QPainterPath LaserTool::mask() const {
    if (!isPenOver() || lying_.isEmpty()) {
        return PenTool::mask();
    }
    return lying_.translated(penPosition() - lyingAt_);
}

} // namespace vs::desktop
