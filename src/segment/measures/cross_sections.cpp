// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/cross_sections.h"

#include "base/parallel.h"
#include "base/progress.h"
#include "base/statistics.h"
#include "segment/measures/wall_fit.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

// A wall is told by the voxels of some layers across the axis.
WallFit fitAt(const Lumen& lumen, const Station& station, double radiusMm) {
    WallFit fit;
    fit.alongMm = station.alongMm;
    fit.sigmaMm = 1.5 * std::max(lumen.stepMm, lumen.apartMm(station.tangent));
    fit.stepMm = lumen.stepMm;
    fit.expectedMm = radiusMm;
    return fit;
}

// The stations whose neighbourhood counts for a fit.
std::pair<std::size_t, std::size_t> groupsAround(const Curve& curve, const WallFit& fit) {
    const auto isBefore = [](const Station& s, double along) { return s.alongMm < along; };
    const auto first =
        std::lower_bound(curve.begin(), curve.end(), fit.alongMm - 2.5 * fit.sigmaMm, isBefore);
    const auto last = std::lower_bound(first, curve.end(), fit.alongMm + 2.5 * fit.sigmaMm, isBefore);
    const auto begin = std::size_t(std::max<std::ptrdiff_t>(0, first - curve.begin() - 1));
    return {begin, std::min(curve.size() - 1, std::size_t(last - curve.begin()))};
}

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

std::vector<CrossSection> crossSections(const Lumen& lumen, const Centreline& line) {
    const auto voxels = wallVoxels(lumen, line.curve, line.radiiMm);
    std::vector<CrossSection> sections(line.curve.size());
    inParallel(int(sections.size()), [&](int section) {
        const auto i = std::size_t(section);
        const WallFit fit = fitAt(lumen, line.curve[i], line.radiiMm[i]);
        const auto [begin, end] = groupsAround(line.curve, fit);
        const auto found = sectionOf(fittedWall(std::span(voxels).subspan(begin, end - begin), fit));
        const double radius = line.radiiMm[i];
        sections[i] =
            isBelievable(lumen, found, radius) ? found : CrossSection{2 * radius, 2 * radius, glm::dvec2(0)};
    });
    return sections;
}

void refine(const Lumen& lumen, Centreline& line) {
    constexpr int kRefiningRounds = 2; // a third one moves nothing by a tenth of a voxel
    for (int round = 0; round < kRefiningRounds; ++round) {
        reportProgress();
        const auto sections = crossSections(lumen, line);
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
}

} // namespace vs::segment
