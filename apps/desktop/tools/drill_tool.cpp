// SPDX-License-Identifier: Apache-2.0
#include "tools/drill_tool.h"

#include "model/studio/studio_controller.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

DrillTool::DrillTool(StudioController& studio) : PenTool(studio, {8, 12, 10}) {}

void DrillTool::setFollowsTilt(bool on) {
    followsTilt_ = on;
    tell();
}

void DrillTool::setGoesThrough(bool on) {
    goesThrough_ = on;
    tell();
}

// Nothing of the volume lies deeper than its diagonal is long.
double DrillTool::strokeDepth() const {
    const volume::GridGeometry* grid = studio_.host().geometry();
    return goesThrough_ && grid != nullptr
               ? std::min(std::ceil(grid->diagonalMm() / grid->stepMm()), studio::kMostSteps)
               : PenTool::strokeDepth();
}

MaskTool::Words DrillTool::words() const {
    const QString draw = tr("Draw the shape of the drill anywhere.");
    if (restores()) {
        return {
            draw,
            tr("The mask follows the pen. Press and move to fill in what was cut. Esc clears it for a new "
               "shape."),
            tr("Filling in: press harder to fill more. Let go to keep, Esc to undo.")};
    }
    return {draw, tr("The mask follows the pen. Press and move to drill. Esc clears it for a new shape."),
            tr("Drilling: press harder to go deeper. Let go to keep, Esc to undo.")};
}

studio::Operation DrillTool::operation(const studio::PenCut& cut) const {
    return studio::Drill{cut, followsTilt_};
}

} // namespace vs::desktop
