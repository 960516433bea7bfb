// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vs::segment {

// Where voxels of the finest level begin that lie in those of a coarser one, along each axis, for a box of
// that. What lies beyond a level's outermost centres belongs to them.
struct FinestEdges {
    FinestEdges(const field::BrickGrid& finest, const field::BrickGrid& level, const Box3& of) : box(of) {
        const glm::dvec3 scale = finest.perSceneVoxel / level.perSceneVoxel;
        const glm::dvec3 offset = finest.origin - level.origin * scale;
        for (int axis = 0; axis < 3; ++axis) {
            for (int v = of.lo[axis]; v <= of.hi[axis]; ++v) {
                const double edge = (v - 0.5) * scale[axis] + offset[axis];
                const bool isFirst = v <= 0;
                const bool isLast = v >= level.dims[axis];
                const int at = isFirst  ? 0
                               : isLast ? finest.dims[axis]
                                        : std::clamp(int(std::ceil(edge - 1e-9)), 0, finest.dims[axis]);
                along[std::size_t(axis)].push_back(at);
            }
        }
    }
    [[nodiscard]] int edge(int axis, int v) const {
        return along[std::size_t(axis)][std::size_t(v - box.lo[axis])];
    }
    [[nodiscard]] Box3 finestIn(const Box3& of) const {
        return {{edge(0, of.lo.x), edge(1, of.lo.y), edge(2, of.lo.z)},
                {edge(0, of.hi.x), edge(1, of.hi.y), edge(2, of.hi.z)}};
    }

    Box3 box;
    std::array<std::vector<int>, 3> along;
};

} // namespace vs::segment
