// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/radiation.h"

#include "base/check.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "sculpt/shaders/bindings.h"

#include <fmt/format.h>

#include <algorithm>

namespace vs::sculpt {

namespace {

// Fixed point: 22 bits after the point round a weight to 1.2e-7, and leave room for 1024 before the sum would
// wrap; it stays at the limit, a quarter of that (see deposit_points.comp).
constexpr unsigned int kFixedOne = 1U << 22;
static_assert(Radiator::kMaxVoxelEnergy * 4 * kFixedOne <= 4294967296.0);

constexpr std::size_t kListHeader = 4 * sizeof(unsigned int);

gl::Defines fixedPointDefines() {
    return {{"FIXED_ONE", fmt::format("{}.0", kFixedOne)},
            {"FIXED_LIMIT", fmt::format("{}u", std::uint32_t(Radiator::kMaxVoxelEnergy) * kFixedOne)},
            {"MAX_POINT_ENERGY", fmt::format("{:.1f}", Radiator::kMaxPointEnergy)}};
}

// Into `width`^3 voxels.
gl::Defines depositDefines(int width) {
    gl::Defines defines = fixedPointDefines();
    defines.emplace_back("WIDTH", std::to_string(width));
    if (!gl::Context::isSoftware()) {
        defines.emplace_back("VS_EXCHANGE", "1");
    }
    return defines;
}

gl::Defines convolveDefines(int axis, int reach) {
    gl::Defines defines = fixedPointDefines();
    defines.emplace_back("AXIS", std::to_string(axis));
    defines.emplace_back("REACH", std::to_string(reach));
    return defines;
}

glm::ivec3 tileOf(glm::ivec3 voxel) { return {voxel.x >> 3, voxel.y >> 3, voxel.z >> 3}; }

} // namespace

Radiator::Radiator()
    : list_("sculpt/shaders/list_tiles.comp"), marks_(4, "radiation tile marks"),
      stages_(4, "radiation tile stages"), lists_{gl::Buffer(kListHeader, "radiation tiles x"),
                                                  gl::Buffer(kListHeader, "radiation tiles y"),
                                                  gl::Buffer(kListHeader, "radiation tiles z")},
      bounds_(6 * sizeof(int), "radiation bounds") {
    for (const int width : {3, 4}) {
        deposit_.with(depositDefines(width)); // compiled now, not in the middle of a stroke
    }
}

void Radiator::growScratch(glm::ivec3 texels) {
    if (deposited_ && glm::all(glm::lessThanEqual(texels, deposited_.size()))) {
        return;
    }
    // Keep what the last shapes needed too, unless that would more than double it.
    if (deposited_) {
        const Box3 both{glm::ivec3(0), glm::max(texels, deposited_.size())};
        texels = both.volume() <= 2 * Box3{glm::ivec3(0), texels}.volume() ? both.hi : texels;
    }
    // Mesa's software renderer compiles a shader anew for a texture whose sides are powers of two, and again
    // for one whose sides are not: a fifth of a second in the middle of a stroke. They never are.
    for (int axis = 0; axis < 3; ++axis) {
        while ((texels[axis] & (texels[axis] - 1)) == 0) {
            texels[axis] += kTile;
        }
    }
    deposited_ = gl::Texture(); // freed first, so that old and new need not fit together
    scratchA_ = gl::Texture();
    scratchB_ = gl::Texture();
    scratchC_ = gl::Texture();
    scratchA_ = gl::Texture(texels, gl::Format::R32F, gl::Filter::Nearest, "radiation a");
    scratchB_ = gl::Texture(texels, gl::Format::R32F, gl::Filter::Nearest, "radiation b");
    // Last: where it is, all are.
    deposited_ = gl::Texture(texels, gl::Format::R32UI, gl::Filter::Nearest, "radiation deposits");
}

void Radiator::begin(const Box3& points, const Box3& within, const Footprint& footprint) {
    const gl::Pass pass("begin radiation");
    if ((open_ || running_) && deposited_) {
        deposited_.clear(); // the last use never came to its finish(), or kept its deposits
    }
    running_ = false;
    round_ = 0;
    footprint_ = footprint;
    within_ = within;
    result_ = {};
    // Points farther outside than the footprint reaches touch nothing in it.
    const glm::ivec3 reach = footprint.reachVoxels() + 1;
    const Box3 useful = intersect(points, {within.lo - reach, within.hi + reach});
    open_ = !useful.isEmpty();
    if (!open_) {
        tileDims_ = glm::ivec3(0);
        return;
    }
    // One voxel more than the footprint, because deposits need a voxel around the point's own.
    const glm::ivec3 lo = tileOf(useful.lo - reach);
    const glm::ivec3 hi = tileOf(useful.hi - 1 + reach) + 1;
    origin_ = lo * kTile;
    tileDims_ = hi - lo;
    growScratch(tileDims_ * kTile);
    const std::size_t tiles = Box3{lo, hi}.volume();
    marks_.reserve(tiles * sizeof(std::uint32_t));
    marks_.clear(0, tiles * sizeof(std::uint32_t));
    stages_.reserve(tiles * sizeof(std::uint32_t));
    for (gl::Buffer& list : lists_) {
        list.reserve(kListHeader + tiles * sizeof(std::uint32_t));
    }
    beginRound();
}

void Radiator::beginRunning(const Box3& points, const Box3& within, const Footprint& footprint) {
    begin(points, within, footprint);
    running_ = open_;
    if (running_ && scratchC_.size() != scratchA_.size()) {
        scratchC_ = gl::Texture(scratchA_.size(), gl::Format::R32F, gl::Filter::Nearest, "radiation c");
    }
}

void Radiator::beginRound() {
    ++round_;
    result_ = {};
    for (gl::Buffer& list : lists_) {
        list.write(std::span<const std::uint32_t>(std::array<std::uint32_t, 4>{0, 0, 1, 0}));
    }
    bounds_.write(std::span<const int>(std::array<int, 6>{1 << 30, 1 << 30, 1 << 30, -1, -1, -1}));
}

void Radiator::deposit(const gl::Buffer& points, std::size_t count) { add(points, count, false); }

void Radiator::takeBack(const gl::Buffer& points, std::size_t count) {
    VS_CHECK(running_ || !open_);
    add(points, count, true);
}

void Radiator::add(const gl::Buffer& points, std::size_t count, bool takesBack) {
    if (running_ && !open_) {
        open_ = true;
        beginRound();
    }
    if (!open_ || count == 0) {
        return;
    }
    VS_CHECK(count <= kMaxPoints && count * sizeof(glm::vec4) <= points.size());
    const gl::Pass pass("deposit points");
    points.bindStorage(kPointsStorage);
    marks_.bindStorage(kMarksStorage);
    deposited_.bindImage(kDepositsImage, gl::Access::ReadWrite);
    const auto& axes = footprint_.axes;
    const glm::ivec3 degrees(axes[0].degree, axes[1].degree, axes[2].degree);
    const bool isCubic = glm::any(glm::equal(degrees, glm::ivec3(3)));
    gl::Program& program = deposit_.with(depositDefines(isCubic ? 4 : 3));
    program.set("count", int(count))
        .set("originVoxel", origin_)
        .set("tileDims", tileDims_)
        .set("degrees", degrees)
        .set("round", round_)
        .set("running", running_ ? (takesBack ? -1 : 1) : 0);
    // Further deposits and the convolution read both images and marks.
    program.dispatchOver({int(count), 1, 1}, gl::Barrier::All);
}

void Radiator::convolve(int axis, const gl::Texture& from, const gl::Texture& to) {
    const AxisFootprint& shape = footprint_.axes[std::size_t(axis)];
    gl::Program& program = convolve_.with(convolveDefines(axis, shape.reach));
    lists_[std::size_t(axis)].bindStorage(kTileListStorage);
    stages_.bindStorage(kStagesStorage);
    deposited_.bindImage(kDepositsImage, gl::Access::ReadWrite);
    from.bindImage(kSourceImage, gl::Access::Read);
    to.bindImage(kResultImage, gl::Access::Write);
    program.set("tileDims", tileDims_)
        .set("keepsDeposits", running_ ? 1 : 0)
        .set("taps", std::span(shape.taps).first(std::size_t(shape.reach) + 1));
    // The lists and stages, which this reads, are written anew by the next round.
    program.dispatchIndirect(lists_[std::size_t(axis)], 0, gl::Barrier::All);
}

Box3 Radiator::finish() {
    if (!open_) {
        result_ = {};
        return {};
    }
    open_ = false;
    const gl::Pass pass("convolve radiation");
    marks_.bindStorage(kMarkedTilesStorage);
    stages_.bindStorage(kStagesStorage);
    for (unsigned int axis = 0; axis < 3; ++axis) {
        lists_[axis].bindStorage(kListXStorage + axis);
    }
    bounds_.bindStorage(kTileBoundsStorage);
    list_.set("tileDims", tileDims_)
        .set("insideLo", tileOf(within_.lo - origin_))
        .set("insideHi", tileOf(within_.hi - 1 - origin_) + 1)
        .set("round", round_);
    list_.dispatchOver(tileDims_, gl::Barrier::All); // lists are read as arguments, by shaders and below
    const gl::Texture& alongX = running_ ? scratchC_ : scratchA_;
    convolve(0, scratchB_, alongX);
    convolve(1, alongX, scratchB_);
    convolve(2, scratchB_, scratchA_);
    const auto bounds = bounds_.read<glm::ivec3>(2);
    if (bounds[1].x >= 0) {
        const Box3 tiles{origin_ + bounds[0] * kTile, origin_ + (bounds[1] + 1) * kTile};
        result_ = intersect(tiles, within_);
    }
    return result_;
}

std::vector<float> Radiator::download(const Box3& box) const {
    std::vector<float> out(box.volume(), 0.0F);
    const Box3 part = intersect(box, result_);
    if (part.isEmpty()) {
        return out;
    }
    const auto stages = stages_.read<std::uint32_t>(Box3{glm::ivec3(0), tileDims_}.volume());
    const auto raw = scratchA_.download({part.lo - origin_, part.hi - origin_});
    const auto* energies = reinterpret_cast<const float*>(raw.data());
    const glm::ivec3 size = part.size();
    for (int z = part.lo.z; z < part.hi.z; ++z) {
        for (int y = part.lo.y; y < part.hi.y; ++y) {
            for (int x = part.lo.x; x < part.hi.x; ++x) {
                const glm::ivec3 tile = tileOf(glm::ivec3(x, y, z) - origin_);
                const bool valid =
                    (stages[(std::size_t(tile.z) * std::size_t(tileDims_.y) + std::size_t(tile.y)) *
                                std::size_t(tileDims_.x) +
                            std::size_t(tile.x)] &
                     8U) != 0;
                const glm::ivec3 from = glm::ivec3(x, y, z) - part.lo;
                const glm::ivec3 to = glm::ivec3(x, y, z) - box.lo;
                const glm::ivec3 outSize = box.size();
                out[(std::size_t(to.z) * std::size_t(outSize.y) + std::size_t(to.y)) *
                        std::size_t(outSize.x) +
                    std::size_t(to.x)] =
                    valid ? energies[(std::size_t(from.z) * std::size_t(size.y) + std::size_t(from.y)) *
                                         std::size_t(size.x) +
                                     std::size_t(from.x)]
                          : 0.0F;
            }
        }
    }
    return out;
}

} // namespace vs::sculpt
