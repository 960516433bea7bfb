// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/cross_sections.h"

#include "base/progress.h"
#include "base/statistics.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

CrossSection sectionOf(const WallShape& wall) {
    constexpr int kAngles = 64;
    CrossSection section;
    double area = 0;
    glm::dvec2 moment(0);
    section.leastDiameterMm = 2 * wall.level();
    for (int i = 0; i < kAngles; ++i) {
        const double angle = glm::two_pi<double>() * i / kAngles;
        const double radius = std::max(0.0, wall.radiusMm(angle));
        const double width = radius + std::max(0.0, wall.radiusMm(angle + glm::pi<double>()));
        section.leastDiameterMm = std::min(section.leastDiameterMm, width);
        area += radius * radius / 2;
        moment += radius * radius * radius / 3 * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    section.middleMm = area > 0 ? moment / area : glm::dvec2(0);
    section.diameterMm = 2 * std::sqrt(2 * area / kAngles);
    return section;
}

// Too few voxels, as beyond the end of a vessel, can make any wall.
bool isBelievable(const Lumen& lumen, const CrossSection& section, double radiusMm) {
    const double most = 0.5 * radiusMm + lumen.coarseMm;
    return std::abs(section.diameterMm / 2 - radiusMm) < most && glm::length(section.middleMm) < most;
}

} // namespace

std::vector<CrossSection> crossSections(const Lumen& lumen, const Centreline& line, const ScanEdges* edges) {
    std::vector<CrossSection> sections;
    const std::vector<WallShape> walls = wallsAlong(lumen, line, edges);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const CrossSection found = sectionOf(walls[i]);
        const double radius = line.radiiMm[i];
        sections.push_back(
            isBelievable(lumen, found, radius) ? found : CrossSection{2 * radius, 2 * radius, glm::dvec2(0)});
    }
    return sections;
}

void refine(const Lumen& lumen, Centreline& line, const ScanEdges* edges) {
    reportProgress();
    const auto sections = crossSections(lumen, line, edges);
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < line.curve.size(); ++i) {
        const Station& station = line.curve[i];
        const glm::dvec2 middle = sections[i].middleMm;
        places.push_back(station.place + middle.x * station.across + middle.y * station.up);
    }
    const double spacing = spacingMm(lumen, median(line.radiiMm));
    const Curve curve = smoothCurve(places, smoothingMm(lumen, line.radiiMm), spacing);
    std::vector<double> radii;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        radii.push_back(line.radiiMm[i * (line.radiiMm.size() - 1) / (curve.size() - 1)]);
    }
    line = {curve, radii};
}

} // namespace vs::segment
