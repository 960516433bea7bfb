// SPDX-License-Identifier: Apache-2.0
#include "tools/sweep_way.h"

#include <cmath>

namespace vs::desktop {

namespace {

void goOn(std::vector<glm::dvec2>& way, glm::dvec2 to) {
    const glm::dvec2 from = way.back();
    const int pixels = int(std::ceil(glm::distance(from, to)));
    for (int n = 1; n <= pixels; ++n) {
        way.push_back(glm::mix(from, to, double(n) / pixels));
    }
}

} // namespace

std::vector<glm::dvec2> wayThrough(const std::vector<glm::dvec2>& corners, SweepTool::Line line) {
    if (line == SweepTool::Line::FreeHand || corners.empty()) {
        return corners;
    }
    std::vector<glm::dvec3> places;
    for (const glm::dvec2 corner : corners) {
        places.emplace_back(corner, 0);
    }
    const auto pieces =
        line == SweepTool::Line::Spline ? sculpt::splinePath(places) : sculpt::polylinePath(places);
    std::vector<glm::dvec2> way{corners.front()};
    for (const sculpt::PathPiece& piece : pieces) {
        goOn(way, glm::dvec2(piece.to.origin));
    }
    return way;
}

} // namespace vs::desktop
