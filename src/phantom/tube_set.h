// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vs::phantom {

// A place that the middle line of a tube passes through, and the tube's radius there, in mm.
struct TubePoint {
    glm::dvec3 place{0};
    double radius = 1;
};

// The smooth curve through the given places (Catmull-Rom splines), as places so close together that straight
// pieces between them look curved.
std::vector<TubePoint> smoothTube(std::span<const TubePoint> through);

// Many curved round tubes, such as vessels, whose distance can be asked at every voxel: chains of cones,
// found by tiles of space. Tubes that meet are blended, so that branches leave each other as in life.
class TubeSet {
public:
    // What is closest to a place.
    struct Nearest {
        double distance = 0;     // signed, to the surface of all tubes; never above the set's reach
        double radius = 0;       // of the closest tube, where it is closest
        double alongMm = 0;      // from that tube's beginning to there
        int tube = -1;           // its number, or -1 beyond reach
        glm::dvec3 middle{0};    // the closest place of its middle line
        glm::dvec3 direction{0}; // of length 1, in which it leads there
    };

    // Distances above `reachMm` are not told apart. The seam of two tubes is rounded over `blendMm`, or over
    // the thinner tube's radius where that is less.
    TubeSet(double reachMm, double blendMm) : reachMm_(reachMm), blendMm_(blendMm) {}

    // Adds the tube along these places, straight between them. Tubes are numbered from 0.
    int add(std::span<const TubePoint> places);
    // Sorts the tubes into tiles. Call it once, after the last `add` and before the first question.
    void finish();

    [[nodiscard]] Nearest nearest(glm::dvec3 p) const;

private:
    struct Cone {
        glm::dvec3 from{0};
        glm::dvec3 axis{0};
        double lengthMm = 0;
        double radiusFrom = 0;
        double radiusTo = 0;
        double alongMm = 0; // of `from`
        int tube = 0;

        [[nodiscard]] double share(glm::dvec3 p) const;
    };

    [[nodiscard]] glm::ivec3 tileOf(glm::dvec3 p) const;
    // The tiles in whose reach a cone may be.
    [[nodiscard]] Box3 tilesNear(const Cone& cone) const;
    template <typename Visit>
    void forEachTileNear(const Cone& cone, const Visit& visit) const;

    double reachMm_;
    double blendMm_;
    int tubeCount_ = 0;
    std::vector<Cone> cones_;
    glm::dvec3 corner_{0}; // of the first tile
    glm::ivec3 tiles_{0};
    std::vector<std::uint32_t> begins_; // where each tile's cones begin, and one entry more
    std::vector<std::uint32_t> sorted_; // numbers of cones, tile after tile, in each in the order of tubes
};

} // namespace vs::phantom
