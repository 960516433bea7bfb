// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/constraints.h"
#include "segment/growth/seed_map.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// Changes of the segment at work other than growing, as passes over whole bricks. Internal to this folder.
class RegionPasses {
public:
    // Says which voxels of the segment at work are meant: those of generations after `last`; with a plane
    // only those of them that are in it, or (not isInPlane) those that are not.
    struct Which {
        int last = 0;
        const gl::Buffer* plane = nullptr;
        bool isInPlane = true;
    };

    using Bricks = std::vector<std::uint32_t>;

    // The bricks among `among` that hold voxels like `which`.
    Bricks holding(SeedMap& seedMap, const Owner& owner, const Which& which, const Bricks& among);
    // Takes voxels like `which` away. With a plane, returns how many were taken of each generation up to
    // `extent`.
    std::vector<std::uint32_t> erase(SeedMap& seedMap, const Owner& owner, const Which& which,
                                     const Bricks& bricks, int extent);

    // The bricks among `among` in which a plane has voxels that are nobody's.
    Bricks withFree(SeedMap& seedMap, const gl::Buffer& plane, const Bricks& among);
    // Gives those voxels of a plane that are nobody's to the segment at work, with one generation. Returns
    // how many there were.
    std::uint32_t add(SeedMap& seedMap, const gl::Buffer& plane, const Bricks& bricks, int generation);

    // The voxels of the segment at work of generations after `last` as a plane (zeros in other bricks must be
    // there already); with constraints, those that these and `forbidden` (null: nothing is) would let in.
    void planeOf(SeedMap& seedMap, const Owner& owner, int last, const field::Field& field,
                 const Constraints* constraints, const gl::Buffer* forbidden, const gl::Buffer& plane,
                 const Bricks& bricks);

    // Sets or clears listed voxels (linear indices) in a plane; adds one plane to another.
    void setBits(SeedMap& seedMap, const gl::Buffer& plane, std::span<const std::uint32_t> voxels,
                 bool isToSet);
    void join(SeedMap& seedMap, const gl::Buffer& plane, const gl::Buffer& added);

private:
    gl::Program& eraser(const SeedMap& seedMap, bool byPlane, bool looks);
    void prepare(gl::Program& program, SeedMap& seedMap, const Owner& owner, const Which& which);

    gl::ProgramVariants erase_{"segment/shaders/erase_voxels.comp"};
    gl::ProgramVariants add_{"segment/shaders/add_voxels.comp"};
    gl::ProgramVariants changeBits_{"segment/shaders/change_bits.comp"};
    gl::ProgramVariants join_{"segment/shaders/join_planes.comp"};
    gl::ProgramVariants ownPlane_{"segment/shaders/region_plane.comp"};
    ConstrainedProgram plane_{"segment/shaders/region_plane.comp"};
    gl::Buffer counts_{4, "counts of voxels"};
};

} // namespace vs::segment
