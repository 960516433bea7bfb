// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/vessel.h"

#include "base/check.h"
#include "base/error.h"
#include "segment/edits/islands.h"
#include "segment/measures/cross_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vs::segment {
namespace {

glm::dvec3 worldOfVoxel(const volume::GridGeometry& geometry, const glm::dvec3& voxel) {
    return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
}

// The voxel of the set within a box that is nearest to a voxel, and how far it is.
struct Nearest {
    glm::ivec3 voxel{0};
    double mm = std::numeric_limits<double>::infinity();
};
Nearest nearestIn(const VoxelSet& set, const Box3& box, const volume::GridGeometry& geometry, glm::ivec3 to) {
    Nearest nearest;
    forEachVoxel(intersect(set.box, box), [&](glm::ivec3 voxel, std::size_t) {
        if (set.contains(voxel)) {
            const glm::dmat3 steps(geometry.worldFromVoxel);
            const double mm = glm::length(steps * glm::dvec3(voxel - to));
            nearest = mm < nearest.mm ? Nearest{voxel, mm} : nearest;
        }
    });
    return nearest;
}

glm::ivec3 onVessel(const VoxelSet& set, const volume::GridGeometry& geometry, glm::ivec3 voxel) {
    const Box3 around = grow({voxel, voxel + 1}, kIslandReach);
    if (const Nearest nearest = nearestIn(set, around, geometry, voxel); std::isfinite(nearest.mm)) {
        return nearest.voxel;
    }
    const Nearest nearest = nearestIn(set, set.box, geometry, voxel);
    if (!std::isfinite(nearest.mm)) {
        throw Error("there is no vessel to measure: the segment is empty");
    }
    throw Error("voxel ({}, {}, {}) is not on the vessel, whose nearest voxel ({}, {}, {}) is {:.1f} mm "
                "away; choose one on it",
                voxel.x, voxel.y, voxel.z, nearest.voxel.x, nearest.voxel.y, nearest.voxel.z, nearest.mm);
}

// The value of a row at a point between two of its elements, by a cubic through four.
double cubic(const std::vector<double>& values, const Between& at) {
    const auto valueAt = [&](std::ptrdiff_t i) {
        return values[std::size_t(std::clamp<std::ptrdiff_t>(i, 0, std::ptrdiff_t(values.size()) - 1))];
    };
    const auto i = std::ptrdiff_t(at.before);
    const double a = valueAt(i - 1);
    const double b = valueAt(i);
    const double c = valueAt(i + 1);
    const double d = valueAt(i + 2);
    const double t = at.part;
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Vessel sampled(const Lumen& lumen, const Centreline& line, const ScanEdges* edges, double first,
               double last) {
    std::vector<double> diameters;
    std::vector<double> leastDiameters;
    for (const CrossSection& section : crossSections(lumen, line, edges)) {
        diameters.push_back(section.diameterMm);
        leastDiameters.push_back(section.leastDiameterMm);
    }
    Vessel vessel;
    vessel.lengthMm = std::abs(last - first);
    const int steps = std::max(1, int(std::ceil(vessel.lengthMm / (0.5 * lumen.stepMm) - 1e-6)));
    for (int i = 0; i <= steps; ++i) {
        const double along = glm::mix(first, last, double(i) / steps);
        const Station station = stationAt(line.curve, along);
        const Between at = between(line.curve, along);
        vessel.points.push_back({glm::dvec3(lumen.voxelFromWorld * glm::dvec4(station.place, 1)),
                                 vessel.lengthMm * i / steps, cubic(diameters, at),
                                 cubic(leastDiameters, at)});
    }
    return vessel;
}

std::optional<ScanEdges> scanEdgesOf(const volume::Volume* values, const Lumen& lumen,
                                     const Centreline& line) {
    return values == nullptr ? std::nullopt : scanEdgesAlong(ScanValues(*values, lumen), lumen, line);
}

} // namespace

Vessel vesselBetween(const VoxelSet& vessel, const volume::GridGeometry& geometry, glm::ivec3 from,
                     glm::ivec3 to, const volume::Volume* values) {
    VS_CHECK(values == nullptr || values->geometry.dims == geometry.dims);
    const glm::ivec3 start = onVessel(vessel, geometry, from);
    const glm::ivec3 end = onVessel(vessel, geometry, to);
    const ConnectedVoxels piece(vessel, start);
    if (!piece.contains(end)) {
        throw Error("no way leads from voxel ({}, {}, {}) to voxel ({}, {}, {}): they lie on parts of the "
                    "vessel that do not touch",
                    from.x, from.y, from.z, to.x, to.y, to.z);
    }
    const Lumen lumen(piece, geometry);
    Centreline line = centrelineAlong(lumen, pathBetween(piece, geometry, start, end));
    refine(lumen, line, nullptr);
    refine(lumen, line, nullptr);
    // Now the axis is good enough to look at the scan's values along it.
    const auto edges = scanEdgesOf(values, lumen, line);
    const ScanEdges* const told = edges ? &*edges : nullptr;
    if (told != nullptr) {
        refine(lumen, line, told);
    }
    return sampled(lumen, line, told, alongNearest(line.curve, worldOfVoxel(geometry, glm::dvec3(start))),
                   alongNearest(line.curve, worldOfVoxel(geometry, glm::dvec3(end))));
}

} // namespace vs::segment
