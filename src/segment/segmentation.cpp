// SPDX-License-Identifier: Apache-2.0
#include "segment/segmentation.h"

#include "field/cell_ranges.h"
#include "gl/pass.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vs::segment {

namespace {

constexpr int kTile = 16;
constexpr int kReach = 3; // voxels that the kernel reaches to either side
constexpr int kPadded = kTile + 2 * kReach;
constexpr int kTilesPerBrick = field::kBrick / kTile;
constexpr double kRadiusSteps = 3.0;
// Tiles smoothed at a time: 512 take 1 MiB of bits and 11 MiB of values.
constexpr std::uint32_t kTilesAtOnce = 512;
constexpr std::uint32_t kMaxGroups = 65535;

// Of one bit a voxel, laid out as in shaders/words.glsl.
std::size_t planeBytes(glm::ivec3 dims) {
    const glm::ivec3 bricks = divideUp(dims, field::kBrick);
    constexpr std::size_t brickBytes = 4096;
    return (std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z) + 1) * brickBytes;
}

// The Gaussian at 0..3 voxels along an axis, normalised. The spacing is at least one step, so sigma is at
// most a voxel and 3 voxels hold all of it that 16 bits show.
glm::vec4 kernel(double stepMm, double spacingMm) {
    const double sigma = kRadiusSteps / 3.0 * stepMm / spacingMm;
    double weights[4];
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        weights[i] = std::exp(-0.5 * i * i / (sigma * sigma));
        sum += i == 0 ? weights[i] : 2 * weights[i];
    }
    return glm::vec4(glm::dvec4(weights[0], weights[1], weights[2], weights[3]) / sum);
}

} // namespace

Segmentation::Segmentation(const volume::GridGeometry& geometry)
    : dims_(geometry.dims), brickDims_(divideUp(geometry.dims, field::kBrick)),
      tileDims_(divideUp(geometry.dims, kTile)), shown_(planeBytes(geometry.dims), "shown voxels"),
      texels_(geometry.dims, gl::Format::R16, gl::Filter::Linear, "segmentation"),
      cells_(field::cellDims(geometry.dims), gl::Format::RG32F, gl::Filter::Nearest, "segmentation cells"),
      pending_(std::size_t(tileDims_.x) * std::size_t(tileDims_.y) * std::size_t(tileDims_.z), 0),
      tiles_(4, "segmentation tiles"), reach_(4, "segmentation reach"),
      rows_(kTilesAtOnce * kPadded * kPadded * sizeof(std::uint32_t), "membership rows"),
      alongXY_(kTilesAtOnce * kPadded * kTile * kTile * sizeof(float), "smoothed along x and y"),
      findChanges_("segment/shaders/find_changed_tiles.comp"), packRows_("segment/shaders/pack_rows.comp"),
      smoothXY_("segment/shaders/smooth_xy.comp"), smoothZ_("segment/shaders/smooth_z.comp"),
      writePlain_("segment/shaders/write_membership.comp"),
      summarize_("segment/shaders/summarize_tiles.comp") {
    const glm::dvec3 spacing = geometry.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        weights_[axis] = kernel(geometry.stepMm(), spacing[axis]);
    }
}

glm::ivec3 Segmentation::tileAt(std::uint32_t tile) const {
    const int i = int(tile);
    return {i % tileDims_.x, i / tileDims_.x % tileDims_.y, i / (tileDims_.x * tileDims_.y)};
}

// Brings the plane of what is shown up to date; returns the tiles of the bricks in which it may have changed.
std::vector<std::uint32_t> Segmentation::show(const Growth& growth) {
    const auto bricks = growth.bricksChangedSince(seenRevision_);
    seenRevision_ = growth.revision();
    if (bricks.empty()) {
        return {};
    }
    growth.show(shown_, bricks, std::vector<std::uint32_t>(256, 1), 1);
    std::vector<std::uint32_t> tiles;
    for (const std::uint32_t brick : bricks) {
        const Box3 box = growth.seedMap().bricks().box(brick);
        const glm::ivec3 lo = box.lo / kTile;
        const glm::ivec3 hi = divideUp(box.hi, kTile);
        for (int z = lo.z; z < hi.z; ++z) {
            for (int y = lo.y; y < hi.y; ++y) {
                for (int x = lo.x; x < hi.x; ++x) {
                    tiles.push_back(std::uint32_t((z * tileDims_.y + y) * tileDims_.x + x));
                }
            }
        }
    }
    return tiles;
}

// Compares membership with what the volume holds, and notes in pending_ where changes reach.
void Segmentation::findChanges(const std::vector<std::uint32_t>& tiles) {
    tiles_.reserve(tiles.size() * sizeof(std::uint32_t));
    tiles_.write(std::span<const std::uint32_t>(tiles));
    reach_.reserve(tiles.size() * sizeof(std::uint32_t));
    reach_.clear();
    tiles_.bindStorage(0);
    reach_.bindStorage(1);
    shown_.bindStorage(3);
    texels_.bindTexture(1);
    findChanges_.set(0, dims_).set(1, brickDims_).set(2, tileDims_);
    for (std::uint32_t first = 0; first < tiles.size(); first += kMaxGroups) {
        findChanges_.set(3, int(first));
        findChanges_.dispatch({int(std::min<std::size_t>(kMaxGroups, tiles.size() - first)), 1, 1},
                              gl::Barrier::Storage);
    }
    const auto reach = reach_.read<std::uint32_t>(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        pending_[tiles[i]] |= reach[i];
    }
}

std::vector<std::uint32_t> Segmentation::tilesToSmooth() {
    std::vector<std::uint32_t> tiles;
    for (std::uint32_t i = 0; i < pending_.size(); ++i) {
        for (int n = 0; n < 27 && pending_[i] != 0; ++n) {
            const glm::ivec3 tile = tileAt(i) + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            if ((pending_[i] >> n & 1U) != 0 && glm::all(glm::greaterThanEqual(tile, glm::ivec3(0))) &&
                glm::all(glm::lessThan(tile, tileDims_))) {
                tiles.push_back(std::uint32_t((tile.z * tileDims_.y + tile.y) * tileDims_.x + tile.x));
            }
        }
        pending_[i] = 0;
    }
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

// Smooths tiles [first, first + count) of the list on the device.
void Segmentation::smooth(std::uint32_t first, std::uint32_t count) {
    shown_.bindStorage(3);
    rows_.bindStorage(1);
    alongXY_.bindStorage(2);
    const auto prepare = [&](gl::Program& program, int axis) {
        program.set(0, dims_).set(1, brickDims_).set(2, tileDims_).set(3, int(first)).set(4, weights_[axis]);
    };
    prepare(packRows_, 0);
    prepare(smoothXY_, 1);
    smoothXY_.set(5, weights_[0]);
    prepare(smoothZ_, 2);
    // Each pass reads what the one before it has written.
    packRows_.dispatchOver({kPadded * kPadded, int(count), 1}, gl::Barrier::Storage);
    smoothXY_.dispatchOver({kPadded * kTile, int(count), 1}, gl::Barrier::Storage);
    texels_.bindImage(0, gl::Access::Write);
    smoothZ_.dispatchOver({kTile * kTile, int(count), 1}, gl::Barrier::Texture);
}

Box3 Segmentation::update(const Growth& growth, Smoothing smoothing) {
    const gl::Pass pass("update segmentation");
    const auto candidates = show(growth);
    if (!candidates.empty()) {
        findChanges(candidates);
    }
    std::vector<std::uint32_t> tiles;
    if (smoothing == Smoothing::Smooth) {
        tiles = tilesToSmooth();
    } else {
        std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(tiles),
                     [&](std::uint32_t tile) { return pending_[tile] != 0; });
    }
    Box3 box;
    for (const std::uint32_t tile : tiles) {
        const glm::ivec3 lo = tileAt(tile) * kTile;
        box = unite(box, {lo, glm::min(lo + kTile, dims_)});
    }
    if (tiles.empty()) {
        return box;
    }
    ++version_;
    tiles_.reserve(tiles.size() * sizeof(std::uint32_t));
    tiles_.write(std::span<const std::uint32_t>(tiles));
    tiles_.bindStorage(0);
    const auto total = std::uint32_t(tiles.size());
    for (std::uint32_t first = 0; first < total; first += kTilesAtOnce) {
        const std::uint32_t count = std::min(kTilesAtOnce, total - first);
        if (smoothing == Smoothing::Smooth) {
            smooth(first, count);
        } else {
            shown_.bindStorage(3);
            texels_.bindImage(0, gl::Access::Write);
            writePlain_.set(0, dims_).set(1, brickDims_).set(2, tileDims_).set(3, int(first));
            writePlain_.dispatchOver({kTile * kTile, int(count), 1}, gl::Barrier::Texture);
        }
    }
    texels_.bindTexture(1);
    cells_.bindImage(1, gl::Access::Write);
    for (std::uint32_t first = 0; first < total; first += kMaxGroups) {
        summarize_.set(0, dims_)
            .set(1, brickDims_)
            .set(2, tileDims_)
            .set(3, int(first))
            .set(5, cells_.size());
        summarize_.dispatch({1, int(std::min(kMaxGroups, total - first)), 1}, gl::Barrier::Texture);
    }
    return box;
}

} // namespace vs::segment
