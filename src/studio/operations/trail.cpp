// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/trail.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

using segment::VoxelSet;

// How far a ball reaches along each voxel axis, in voxels.
glm::dvec3 reachOf(double radiusMm, const volume::GridGeometry& geometry) {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(geometry.voxelFromWorld()));
    return radiusMm * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
}

// Everything that a brush can reach, clipped to the grid.
Box3 boxAround(const Trail& trail, const volume::GridGeometry& geometry) {
    glm::dvec3 lo = trail.points.front();
    glm::dvec3 hi = lo;
    for (const glm::dvec3 point : trail.points) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    const glm::dvec3 reach = reachOf(trail.radiusMm, geometry);
    const glm::dvec3 farthest(geometry.dims + 1); // before whole numbers cannot hold it
    Box3 box{glm::ivec3(glm::clamp(glm::floor(lo - reach), glm::dvec3(-1), farthest)),
             glm::ivec3(glm::clamp(glm::ceil(hi + reach), glm::dvec3(-1), farthest)) + 1};
    if (trail.axis) {
        const int layer =
            int(std::clamp(std::floor(trail.points.front()[*trail.axis] + 0.5), -1.0, farthest[*trail.axis]));
        box.lo[*trail.axis] = layer;
        box.hi[*trail.axis] = layer + 1;
    }
    return intersect(box, geometry.box());
}

// Marks the voxels within the radius of the line from a to b (voxel space).
void markAround(glm::dvec3 a, glm::dvec3 b, double radiusMm, const volume::GridGeometry& geometry,
                VoxelSet& set) {
    const glm::dmat3 mmFromVoxel(geometry.worldFromVoxel);
    const glm::dvec3 reach = reachOf(radiusMm, geometry);
    const Box3 near = intersect(set.box, {glm::ivec3(glm::floor(glm::min(a, b) - reach)),
                                          glm::ivec3(glm::ceil(glm::max(a, b) + reach)) + 1});
    const glm::dvec3 way = mmFromVoxel * (b - a);
    const double perLength = glm::dot(way, way) > 0 ? 1 / glm::dot(way, way) : 0;
    for (int z = near.lo.z; z < near.hi.z; ++z) {
        for (int y = near.lo.y; y < near.hi.y; ++y) {
            std::size_t i = set.indexOf({near.lo.x, y, z});
            for (int x = near.lo.x; x < near.hi.x; ++x, ++i) {
                if (set.inside[i] != 0) {
                    continue; // of an earlier piece: most are
                }
                const glm::dvec3 offset = mmFromVoxel * (glm::dvec3(x, y, z) - a);
                const double along = std::clamp(glm::dot(offset, way) * perLength, 0.0, 1.0);
                const glm::dvec3 apart = offset - along * way;
                set.inside[i] = glm::dot(apart, apart) <= radiusMm * radiusMm ? 1 : 0;
            }
        }
    }
}

// Marks the voxels that the line itself runs through.
void markThrough(glm::dvec3 a, glm::dvec3 b, VoxelSet& set) {
    constexpr double kPerVoxel = 8;
    const int steps = 1 + int(kPerVoxel * glm::length(b - a));
    for (int step = 0; step <= steps; ++step) {
        const glm::ivec3 voxel(glm::floor(glm::mix(a, b, double(step) / steps) + 0.5));
        const Box3& box = set.box;
        if (glm::all(glm::greaterThanEqual(voxel, box.lo)) && glm::all(glm::lessThan(voxel, box.hi))) {
            set.inside[set.indexOf(voxel)] = 1;
        }
    }
}

} // namespace

segment::VoxelSet voxelsAlong(const Trail& trail, const volume::GridGeometry& geometry) {
    const Box3 box = boxAround(trail, geometry);
    if (box.isEmpty()) {
        return {};
    }
    VoxelSet set = segment::emptySet(box);
    // A disc's points all lie in its slice.
    const auto point = [&](std::size_t n) {
        glm::dvec3 p = trail.points[n];
        if (trail.axis) {
            p[*trail.axis] = box.lo[*trail.axis];
        }
        return p;
    };
    for (std::size_t n = 0; n < trail.points.size(); ++n) {
        const glm::dvec3 from = point(n == 0 ? 0 : n - 1);
        markAround(from, point(n), trail.radiusMm, geometry, set);
        markThrough(from, point(n), set);
    }
    return set.tight();
}

segment::VoxelSet voxelsAlong(const Trail& trail, const volume::Volume& volume,
                              const std::optional<Range>& range) {
    VoxelSet set = voxelsAlong(trail, volume.geometry);
    for (std::size_t i = 0; range && i < set.inside.size(); ++i) {
        if (set.inside[i] != 0 && !range->contains(volume.at(set.voxelAt(i)))) {
            set.inside[i] = 0;
        }
    }
    return set;
}

} // namespace vs::studio
