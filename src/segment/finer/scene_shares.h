// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_growth.h"
#include "segment/finer/finest_edges.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// What a brick of the scene has of segments at the finest level: of each voxel of its box, x fastest.
struct SceneShares {
    std::vector<std::uint8_t> labels;       // the segment with the largest share; 0: none has any
    std::vector<std::uint8_t> halves;       // that segment, where it has at least half; else 0
    std::vector<std::uint32_t> generations; // in which it got to have half, or all that it has
};

// Works out such shares. Bricks of the scene may be worked out by several threads, each with its own counter.
class ShareCounter {
public:
    // Generations of the segment at work after `upTo` do not count. The growth and the edges must stay.
    ShareCounter(const FineGrowth& finest, const FinestEdges& edges, int upTo)
        : finest_(finest), edges_(edges), upTo_(upTo) {}

    // Works out the shares of some voxels of a brick of the scene, which all lie in the edges' box.
    void count(const Box3& voxels, const Box3& brick, SceneShares& shares);

private:
    struct Voxel { // one that has grown at the finest level
        std::uint32_t generation = 0;
        std::uint8_t label = 0;
    };
    struct Placed {
        std::uint32_t place = 0; // of the scene's voxel that it lies in
        Voxel voxel;
    };

    struct Share {
        std::uint8_t label = 0;
        bool isHalf = false;
        std::uint32_t generation = 0;
    };
    static void put(SceneShares& shares, std::size_t at, const Share& share);

    void layOut(const Box3& voxels, const Box3& inside);
    [[nodiscard]] bool isByTiles(const Box3& voxels, const Box3& inside) const;
    void countTiles(const FineCells& cells, const Box3& voxels, const Box3& brick, SceneShares& shares);
    void collect(const FineCells& cells, glm::ivec3 lo, const Box3& part);
    void sort(std::size_t places);
    static void partByLabel(std::span<Voxel> voxels);

    const FineGrowth& finest_;
    const FinestEdges& edges_;
    int upTo_;
    // Which voxel of a box along an axis each finest one in it lies in, from the first one on.
    std::array<std::vector<std::uint32_t>, 3> along_;
    glm::ivec3 first_{0};
    glm::uvec3 size_{1}; // the box's, in the scene's voxels
    std::vector<Placed> placed_;
    std::vector<Voxel> sorted_;        // by place
    std::vector<std::uint32_t> end_;   // of each place, in that list
    std::vector<std::uint32_t> grown_; // generations in a tile, by the scene's voxel
};

} // namespace vs::segment
