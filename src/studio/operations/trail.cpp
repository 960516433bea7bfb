// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/trail.h"

#include "base/capsule.h"
#include "base/progress.h"
#include "studio/operations/filled_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

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

// A brush that marks the voxels of a set's box where it goes.
class Brush {
public:
    Brush(VoxelSet& set, double radiusMm, const volume::GridGeometry& geometry)
        : set_(set), radiusMm_(radiusMm), reach_(reachOf(radiusMm, geometry)),
          mmFromVoxel_(geometry.worldFromVoxel),
          rows_(std::size_t(set.box.size().y) * std::size_t(set.box.size().z), set.box.size().x) {}

    // Along a straight way (voxel space).
    void go(glm::dvec3 a, glm::dvec3 b) {
        markAround(a, b);
        markThrough(a, b);
    }

private:
    // The voxels within the radius of the way.
    void markAround(glm::dvec3 a, glm::dvec3 b) {
        const glm::dvec3 lo(set_.box.lo);
        const glm::dvec3 hi(set_.box.hi);
        const glm::ivec3 first(glm::clamp(glm::floor(glm::min(a, b) - reach_), lo, hi));
        const glm::ivec3 end(glm::clamp(glm::ceil(glm::max(a, b) + reach_) + 1.0, lo, hi));
        // Places are in mm from the way's beginning, for the sake of digits.
        const Capsule<3> around{glm::dvec3(0), mmFromVoxel_ * (b - a), radiusMm_};
        for (int z = first.z; z < end.z; ++z) {
            for (int y = first.y; y < end.y; ++y) {
                if (const auto part =
                        around.onLine(mmFromVoxel_ * (glm::dvec3(0, y, z) - a), mmFromVoxel_[0])) {
                    fill(y, z, std::clamp(std::ceil(part->lo), lo.x, hi.x),
                         std::clamp(std::floor(part->hi) + 1, lo.x, hi.x));
                }
            }
        }
    }

    void fill(int y, int z, double begin, double end) {
        const Box3& box = set_.box;
        const std::size_t row =
            std::size_t(z - box.lo.z) * std::size_t(box.size().y) + std::size_t(y - box.lo.y);
        auto* const voxels = set_.inside.data() + row * std::size_t(box.size().x);
        rows_.fill(row, int(begin) - box.lo.x, int(end) - box.lo.x,
                   [&](int from, int to) { std::fill(voxels + from, voxels + to, std::uint8_t(1)); });
    }

    // The voxels that the way itself runs through.
    void markThrough(glm::dvec3 a, glm::dvec3 b) {
        constexpr double kPerVoxel = 8;
        const int steps = 1 + int(kPerVoxel * glm::length(b - a));
        Range near{0, 1};
        for (int axis = 0; axis < 3; ++axis) { // the part of it that may run through the box
            const auto part =
                sharesWithin(a[axis], b[axis], {set_.box.lo[axis] - 1.0, set_.box.hi[axis] + 0.0});
            if (!part) {
                return;
            }
            near = {std::max(near.lo, part->lo), std::min(near.hi, part->hi)};
        }
        const int last = int(std::min(std::ceil(near.hi * steps), double(steps)));
        for (int step = int(near.lo * steps); step <= last; ++step) {
            const glm::ivec3 voxel(glm::floor(glm::mix(a, b, double(step) / steps) + 0.5));
            const Box3& box = set_.box;
            if (glm::all(glm::greaterThanEqual(voxel, box.lo)) && glm::all(glm::lessThan(voxel, box.hi))) {
                set_.inside[set_.indexOf(voxel)] = 1;
            }
        }
    }

    VoxelSet& set_;
    double radiusMm_;
    glm::dvec3 reach_;
    glm::dmat3 mmFromVoxel_;
    FilledRows rows_;
};

// The voxels of a box under a trail.
VoxelSet marked(const Trail& trail, const volume::GridGeometry& geometry, const Box3& box) {
    VoxelSet set = segment::emptySet(box);
    // A disc's points all lie in its slice.
    const auto point = [&](std::size_t n) {
        glm::dvec3 p = trail.points[n];
        if (trail.axis) {
            p[*trail.axis] = box.lo[*trail.axis];
        }
        return p;
    };
    Brush brush(set, trail.radiusMm, geometry);
    for (std::size_t n = 0; n < trail.points.size(); ++n) {
        brush.go(point(n == 0 ? 0 : n - 1), point(n));
    }
    return set;
}

// The trail in a finer level's voxel space.
Trail toldTo(Trail trail, const field::BrickGrid& grid) {
    for (glm::dvec3& point : trail.points) {
        point = point * grid.perSceneVoxel + grid.origin;
    }
    return trail;
}

// Adds what lies under a trail of the set's own grid, piece by piece.
void addMarked(segment::FineSet& set, const Trail& trail, const volume::GridGeometry& geometry) {
    constexpr int kSide = 128; // of a piece
    const Box3 box = boxAround(trail, geometry);
    if (box.isEmpty()) {
        return;
    }
    std::set<std::array<int, 3>> pieces; // that some stretch of the trail reaches
    for (std::size_t n = 0; n < trail.points.size(); ++n) {
        Trail stretch = trail;
        stretch.points = {trail.points[n == 0 ? 0 : n - 1], trail.points[n]};
        if (trail.axis) { // a disc's points all lie in its slice
            stretch.points.front()[*trail.axis] = trail.points.front()[*trail.axis];
        }
        const Box3 reached = boxAround(stretch, geometry);
        forEachVoxel(Box3{reached.lo / kSide, divideUp(reached.hi, kSide)}, [&](glm::ivec3 at, std::size_t) {
            pieces.insert({at.z, at.y, at.x});
        });
    }
    for (const auto& [z, y, x] : pieces) {
        reportProgress();
        const glm::ivec3 at(x, y, z);
        const VoxelSet part = marked(trail, geometry, intersect(box, {at * kSide, (at + 1) * kSide}));
        set.add(part.box, part.box, part.inside);
    }
}

} // namespace

segment::VoxelSet voxelsAlong(const Trail& trail, const volume::GridGeometry& geometry) {
    const Box3 box = boxAround(trail, geometry);
    return box.isEmpty() ? VoxelSet() : marked(trail, geometry, box).tight();
}

segment::FineSet finestAlong(const Trail& trail, const field::BrickGrid& grid,
                             const volume::GridGeometry& finer) {
    segment::FineSet set(grid.dims);
    Trail finest = toldTo(trail, grid);
    if (!trail.axis) {
        addMarked(set, finest, finer);
        return set;
    }
    // The slice's layers: those whose centres lie in it.
    const int axis = *trail.axis;
    const double slice = std::floor(trail.points.front()[axis] + 0.5);
    const auto inLevel = [&](double p) { return p * grid.perSceneVoxel[axis] + grid.origin[axis]; };
    const double first = std::max(std::ceil(inLevel(slice - 0.5)), 0.0);
    const double end = std::min(std::ceil(inLevel(slice + 0.5)), double(grid.dims[axis]));
    for (double layer = first; layer < end; ++layer) {
        finest.points.front()[axis] = layer;
        addMarked(set, finest, finer);
    }
    return set;
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
