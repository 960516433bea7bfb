// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/lumen.h"

#include "base/statistics.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

// Walks around the rays, from one whose wall was met to the next, and gives those between them the radii
// between theirs.
void closeOpenRays(Outline& outline) {
    const auto firstClosed = std::find(outline.isOpen.begin(), outline.isOpen.end(), false);
    if (firstClosed == outline.isOpen.end()) {
        return;
    }
    const auto first = std::size_t(firstClosed - outline.isOpen.begin());
    for (std::size_t begin = 0; begin < kRays;) {
        std::size_t end = begin + 1;
        while (outline.isOpen[(first + end) % kRays]) {
            ++end;
        }
        const double from = outline.radiiMm[(first + begin) % kRays];
        const double to = outline.radiiMm[(first + end) % kRays];
        for (std::size_t i = begin + 1; i < end; ++i) {
            outline.radiiMm[(first + i) % kRays] =
                glm::mix(from, to, double(i - begin) / double(end - begin));
        }
        begin = end;
    }
}

glm::dvec2 middleOf(const std::array<double, kRays>& radii) {
    glm::dvec2 moment(0);
    double area = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const double angle = glm::two_pi<double>() * double(i) / double(kRays);
        const double squared = radii[i] * radii[i];
        moment += squared * radii[i] / 3 * glm::dvec2(std::cos(angle), std::sin(angle));
        area += squared / 2;
    }
    return area > 0 ? moment / area : glm::dvec2(0);
}

} // namespace

glm::dvec3 rayOf(const Station& station, std::size_t ray) {
    const double angle = glm::two_pi<double>() * double(ray) / double(kRays);
    return std::cos(angle) * station.across + std::sin(angle) * station.up;
}

Lumen::Lumen(const ConnectedVoxels& piece, const volume::GridGeometry& geometry)
    : voxels(piece), worldFromVoxel(geometry.worldFromVoxel), voxelFromWorld(geometry.voxelFromWorld()),
      gridDims(geometry.dims), stepMm(geometry.stepMm()), coarseMm(glm::compMax(geometry.spacing())) {}

int Lumen::coarseAxis() const {
    int coarse = 0;
    for (const int axis : {1, 2}) {
        if (glm::length(worldFromVoxel[axis]) > glm::length(worldFromVoxel[coarse])) {
            coarse = axis;
        }
    }
    return coarse;
}

bool Lumen::contains(const glm::dvec3& place) const {
    return voxels.contains(glm::ivec3(glm::round(glm::dvec3(voxelFromWorld * glm::dvec4(place, 1)))));
}

double Lumen::apartMm(const glm::dvec3& direction) const {
    return glm::compMax(glm::abs(direction * glm::dmat3(worldFromVoxel)));
}

double wallMm(const Lumen& lumen, const glm::dvec3& place, const glm::dvec3& direction, double reachMm) {
    const double step = 0.25 * lumen.stepMm;
    const glm::dvec3 start(lumen.voxelFromWorld * glm::dvec4(place, 1));
    const glm::dvec3 way = step * (glm::dmat3(lumen.voxelFromWorld) * direction);
    const int steps = int(reachMm / step);
    for (int i = 0; i < steps; ++i) {
        if (!lumen.voxels.contains(glm::ivec3(glm::round(start + double(i) * way)))) {
            return std::max(0.0, (i - 0.5) * step);
        }
    }
    return reachMm;
}

Outline outlineAround(const Lumen& lumen, const Station& station, double reachMm, Where where) {
    Outline outline;
    for (std::size_t i = 0; i < kRays; ++i) {
        const glm::dvec3 direction = rayOf(station, i);
        outline.radiiMm[i] = wallMm(lumen, station.place, direction, reachMm);
    }
    const auto radii = outline.radiiMm;
    const double median = vs::median({radii.begin(), radii.end()});
    for (std::size_t i = 0; i < kRays; ++i) {
        // A round vessel that is looked at from half its radius off its axis reaches 1.7 times the median.
        double expected = 1.6 * median + 0.5 * lumen.coarseMm;
        if (where == Where::InTheMiddle) {
            const double other = radii[(i + kRays / 2) % kRays];
            expected =
                std::min(expected, 1.1 * std::max(median, other) + 0.7 * lumen.apartMm(rayOf(station, i)));
        }
        outline.isOpen[i] = radii[i] >= std::min(expected, reachMm);
    }
    closeOpenRays(outline);
    outline.typicalMm = vs::median({outline.radiiMm.begin(), outline.radiiMm.end()});
    outline.middleMm = middleOf(outline.radiiMm);
    return outline;
}

} // namespace vs::segment
