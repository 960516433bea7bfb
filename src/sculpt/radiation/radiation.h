// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "sculpt/radiation/footprint.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vs::sculpt {

// Tiles of 8^3 voxels: what the radiation keeps track of, so that its cost follows what is touched.
inline constexpr int kTile = 8;

// Spreads points' energy over the voxels around them (doc/behaviour.md, "Point radiation"): E(v) = sum over
// points of w * Gaussian(v - p). By linearity the points are first deposited into single voxels with B-spline
// weights, then the touched tiles are convolved with the separable taps of a Footprint. Deposits are
// fixed-point integer atomics, so the result does not depend on the order of execution. Use: begin(),
// deposit() any number of times, finish(), then read energy() until the next begin().
//
// A running radiation (beginRunning) keeps its deposits and what was convolved before: after each finish()
// points may be deposited further, or taken back to the last bit, and the next finish() convolves only the
// tiles that this reaches.
//
// Bounds: energies from 0 to kMaxPointEnergy a point (others are clamped), and a voxel's own deposit
// saturates at kMaxVoxelEnergy; calibrated solids (density 1) stay near 1. In a running radiation it must
// stay below four times that.
class Radiator {
public:
    static constexpr float kMaxPointEnergy = 16;
    static constexpr float kMaxVoxelEnergy = 256;
    static constexpr std::size_t kMaxPoints = std::size_t(1) << 19; // of one deposit(): 100 ms on llvmpipe

    Radiator();

    // `points` is a box of voxels, all centres within half a voxel of which the points lie (points elsewhere
    // are left out); it may reach beyond the grid of `dims` voxels, outside of which nothing is computed.
    void begin(const Box3& points, glm::ivec3 dims, const Footprint& footprint) {
        begin(points, Box3{glm::ivec3(0), dims}, footprint);
    }
    // Computes what lies `within` a box, of tiles where it does not end with the grid: there the result is
    // that of the whole grid, to the bit.
    void begin(const Box3& points, const Box3& within, const Footprint& footprint);
    // Adds the first `count` points of a buffer of vec4: xyz in voxel space, w energy (voxels of density 1).
    void deposit(const gl::Buffer& points, std::size_t count);
    // Convolves. Returns the box of voxels that may have energy: touched tiles, clipped to the grid.
    Box3 finish();

    // Begins a running radiation: rounds of deposit(), takeBack() and finish() until the next begin of either
    // kind. Takes what begin() takes. Results and their lists are those of the last round's tiles;
    // resultBox() is where energies may have changed.
    void beginRunning(const Box3& points, const Box3& within, const Footprint& footprint);
    // Undoes a deposit() of the very same points.
    void takeBack(const gl::Buffer& points, std::size_t count);

    // The result (R32F, valid only in the tiles listed): texel t holds voxel originVoxel() + t.
    [[nodiscard]] const gl::Texture& energy() const { return scratchA_; }
    [[nodiscard]] glm::ivec3 originVoxel() const { return origin_; }
    // Binds the list of result tiles as storage `binding` for a dispatchIndirect(tileArguments(),
    // tileOffset()) of one 8 x 8 work group a tile; shaders include "sculpt/shaders/tiles.glsl".
    void bindResultTiles(unsigned int binding) const { lists_[2].bindStorage(binding); }
    [[nodiscard]] const gl::Buffer& tileArguments() const { return lists_[2]; }
    // Binds one uint a tile, of which bit 4 is set for those listed.
    void bindStages(unsigned int binding) const { stages_.bindStorage(binding); }
    [[nodiscard]] glm::ivec3 tileDims() const { return tileDims_; }
    [[nodiscard]] Box3 resultBox() const { return result_; }
    // Energies of a box of voxels, x fastest, zero where nothing was touched.
    [[nodiscard]] std::vector<float> download(const Box3& box) const;

private:
    void growScratch(glm::ivec3 texels);
    void beginRound();
    void add(const gl::Buffer& points, std::size_t count, bool takesBack);
    void convolve(int axis, const gl::Texture& from, const gl::Texture& to);

    gl::ProgramVariants deposit_{"sculpt/shaders/deposit_points.comp"};
    gl::Program list_;
    gl::ProgramVariants convolve_{"sculpt/shaders/convolve_tiles.comp"};
    gl::Texture deposited_; // R32UI, zero between finish() and begin() unless running
    gl::Texture scratchA_;
    gl::Texture scratchB_;
    gl::Texture scratchC_; // along x, while running: made when first needed
    gl::Buffer marks_;     // one uint a tile: the last round that deposited there
    // One uint a tile: bit 0 deposits, bits 1 to 3 valid after the pass along x, y, z, bit 4 a result.
    gl::Buffer stages_;
    std::array<gl::Buffer, 3> lists_; // indirect arguments, then the tiles of the pass along x, y, z
    gl::Buffer bounds_;               // lowest and highest result tile
    Footprint footprint_;
    Box3 within_;
    glm::ivec3 origin_{0};
    glm::ivec3 tileDims_{0};
    Box3 result_;
    bool open_ = false;
    bool running_ = false;
    int round_ = 0;
};

} // namespace vs::sculpt
