// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "segment/brick_table.h"
#include "segment/constraints.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// Expands a region by whole generations on the device. Beside the seed map it keeps one bit a voxel (in words
// of 4 x 4 x 2 voxels) for what is decided, what is newest and what is on offer, and lists of the words at
// work; the lists have room for every word, so no frontier is too large for them. All of it can be made anew
// from the seed map. Internal to this folder.
class Frontier {
public:
    // At most this many expansions in one submission.
    static constexpr int kMaxSteps = 128;

    // Throws GlError when there are more voxels than its lists can name, or no room on the device.
    explicit Frontier(glm::ivec3 dims);

    // The rules or the seed map have changed: the next expansion tries the neighbours of every grown voxel
    // again.
    void invalidate();
    // Voxels (linear indices) that were given the newest generation.
    void add(std::span<const std::uint32_t> voxels);

    // Tries `steps` (at most kMaxSteps) expansions; the first gives `generation`. Returns the voxels grown by
    // each.
    std::vector<std::uint64_t> expand(gl::Texture& seedMap, BrickTable& bricks, const field::Field& field,
                                      const Constraints& constraints, int generation, int steps);

private:
    void collect(const gl::Texture& seedMap, const BrickTable& bricks);
    void pushAdded();

    glm::ivec3 dims_;
    glm::ivec3 wordDims_;
    gl::Buffer decided_;
    gl::Buffer frontier_;
    gl::Buffer offers_;
    gl::Buffer parents_;
    gl::Buffer candidates_;
    gl::Buffer steps_;
    gl::Buffer list_; // brick or voxel indices on their way to the device
    std::vector<std::uint32_t> added_;
    std::uint32_t parentCount_ = 0;
    bool isValid_ = false;

    gl::Program collectGrown_;
    gl::Program pushSeeds_;
    std::array<gl::Program, 2> spread_; // by connectivity, compiled when first needed
    std::array<gl::Program, 2> commit_; // without and with a fence
};

} // namespace vs::segment
