// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/segmentation.h"

#include "base/timer.h"
#include "field/cell_ranges.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "segment/membership/membership.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kPadded = Segmentation::kTile + 2 * kKernelReach;

} // namespace

Segmentation::Segmentation(const volume::GridGeometry& geometry)
    : dims_(geometry.dims), brickDims_(divideUp(geometry.dims, field::kBrick)),
      tileDims_(divideUp(geometry.dims, kTile)),
      cells_(field::cellDims(geometry.dims), gl::Format::RG32F, gl::Filter::Nearest, "segmentation cells"),
      tiles_(4, "segmentation tiles"), reach_(4, "segmentation reach"), labelsOfTiles_(4, "labels of tiles"),
      rows_(sizeof(std::uint32_t) * kTilesAtOnce * kPadded * kPadded, "membership rows"),
      alongXY_(sizeof(float) * kTilesAtOnce * kPadded * kTile * kTile, "smoothed along x and y"),
      smoothXY_("segment/shaders/smooth_xy.comp") {
    const glm::dvec3 spacing = geometry.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        weights_[axis] = smoothingKernel(geometry.stepMm(), spacing[axis]);
    }
    takeLooks(allOpaque());
}

// For shaders that include shaders/segmentation_image.glsl.
gl::Defines Segmentation::imageDefines(const Of& what) const {
    if (what.isApart) {
        return {{"VS_APART", "1"}};
    }
    return channels_.size() > 1 ? gl::Defines{{"VS_GLASS", "1"}} : gl::Defines{};
}

gl::Defines Segmentation::memberDefines() const {
    return continuation_ ? gl::Defines{{"VS_CONTINUED", "1"}} : gl::Defines{};
}

// For shaders that include shaders/tiles.glsl.
void Segmentation::bindMembers(const Channel& channel, const Of& what) const {
    channel.shown.bindStorage(kShownStorage);
    if (continuation_) {
        (what.isApart ? turnedAlone_ : channel.turned).bindStorage(kTurnedStorage);
    }
}

std::uint32_t Segmentation::tileIndex(glm::ivec3 place) const {
    return std::uint32_t((place.z * tileDims_.y + place.y) * tileDims_.x + place.x);
}

glm::ivec3 Segmentation::tileAt(std::uint32_t tile) const {
    const int i = int(tile);
    return {i % tileDims_.x, i / tileDims_.x % tileDims_.y, i / (tileDims_.x * tileDims_.y)};
}

void Segmentation::listTiles(const std::vector<std::uint32_t>& tiles) {
    tiles_.reserve(tiles.size() * sizeof(std::uint32_t));
    tiles_.write(std::span<const std::uint32_t>(tiles));
    tiles_.bindStorage(kTilesStorage);
}

// Queues the tiles that pending changes reach.
void Segmentation::queueTiles(Channel& channel) const {
    std::vector<std::uint32_t> tiles;
    for (std::uint32_t i = 0; i < channel.pending.size(); ++i) {
        std::uint32_t& pending = channel.pending[i];
        for (int n = 0; n < 27 && pending != 0; ++n) {
            const glm::ivec3 tile = tileAt(i) + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
            if ((pending >> n & 1U) != 0 && glm::all(glm::greaterThanEqual(tile, glm::ivec3(0))) &&
                glm::all(glm::lessThan(tile, tileDims_)) && !channel.isQueued[tileIndex(tile)]) {
                tiles.push_back(tileIndex(tile));
                channel.isQueued[tiles.back()] = true;
            }
        }
        pending = 0;
    }
    std::sort(tiles.begin(), tiles.end()); // neighbours together
    channel.queue.insert(channel.queue.end(), tiles.begin(), tiles.end());
}

// Returns the tiles that were smoothed.
std::vector<std::uint32_t> Segmentation::smoothQueued(int channel, double budgetMs) {
    const Timer timer;
    Channel& own = channels_[std::size_t(channel)];
    const bool isHurried = budgetMs < kNoHurry;
    std::vector<std::uint32_t> done;
    while (!own.queue.empty() && (done.empty() || timer.milliseconds() < budgetMs)) {
        constexpr std::size_t kAtOnce = 32; // tiles, before the clock is read again
        const auto end = own.queue.begin() +
                         std::ptrdiff_t(std::min(isHurried ? kAtOnce : own.queue.size(), own.queue.size()));
        const std::vector<std::uint32_t> tiles(own.queue.begin(), end);
        own.queue.erase(own.queue.begin(), end);
        for (const std::uint32_t tile : tiles) {
            own.isQueued[tile] = false;
        }
        write(channel, tiles, Smoothing::Smooth);
        done.insert(done.end(), tiles.begin(), tiles.end());
        if (isHurried) {
            gl::Context::finish();
        }
    }
    return done;
}

// Smooths tiles [first, first + count) of the list on the device.
void Segmentation::smooth(int channel, std::uint32_t first, std::uint32_t count, const Of& what) {
    bindMembers(channels_[std::size_t(channel)], what);
    rows_.bindStorage(kRowsStorage);
    alongXY_.bindStorage(kAlongXYStorage);
    const auto prepare = [&](gl::Program& program, int axis) {
        program.set("dims", dims_)
            .set("brickDims", brickDims_)
            .set("tileDims", tileDims_)
            .set("firstTile", int(first))
            .set("weights", weights_[axis]);
    };
    gl::Defines defines = memberDefines();
    if (what.isApart) {
        defines.emplace_back("VS_APART", "1");
    }
    gl::Program& packRows = packRows_.with(defines);
    gl::Program& smoothZ = smoothZ_.with(imageDefines(what));
    prepare(packRows, 0);
    prepare(smoothXY_, 1);
    smoothXY_.set("weightsX", weights_[0]);
    prepare(smoothZ, 2);
    if (what.isApart) {
        packRows.set("ownLabel", std::uint32_t(what.label));
    } else if (channels_.size() > 1) {
        smoothZ.set("channel", channel);
    }
    // Each pass reads what the one before it has written.
    packRows.dispatchOver({kPadded * kPadded, int(count), 1}, gl::Barrier::Storage);
    smoothXY_.dispatchOver({kPadded * kTile, int(count), 1}, gl::Barrier::Storage);
    (what.isApart ? apart_->texels() : texels_).bindImage(kSegmentationImage, gl::Access::ReadWrite);
    // The image is read as a texture; the rows are written again for the next tiles.
    smoothZ.dispatchOver({kTile * kTile, int(count), 1}, gl::Barrier::All);
}

// The same without smoothing.
void Segmentation::writePlain(int channel, std::uint32_t first, std::uint32_t count, const Of& what) {
    gl::Defines defines = memberDefines();
    const auto image = imageDefines(what);
    defines.insert(defines.end(), image.begin(), image.end());
    gl::Program& writePlain = writePlain_.with(defines);
    bindMembers(channels_[std::size_t(channel)], what);
    (what.isApart ? apart_->texels() : texels_).bindImage(kSegmentationImage, gl::Access::ReadWrite);
    writePlain.set("dims", dims_)
        .set("brickDims", brickDims_)
        .set("tileDims", tileDims_)
        .set("firstTile", int(first));
    if (what.isApart) {
        writePlain.set("ownLabel", std::uint32_t(what.label));
    } else if (channels_.size() > 1) {
        writePlain.set("channel", channel);
    }
    writePlain.dispatchOver({kTile * kTile, int(count), 1}, gl::Barrier::All); // what is shown changes next
}

void Segmentation::write(int channel, const std::vector<std::uint32_t>& tiles, Smoothing smoothing) {
    listTiles(tiles);
    const auto total = std::uint32_t(tiles.size());
    for (std::uint32_t first = 0; first < total; first += kTilesAtOnce) {
        const std::uint32_t count = std::min(kTilesAtOnce, total - first);
        if (smoothing == Smoothing::Smooth) {
            smooth(channel, first, count, {});
        } else {
            writePlain(channel, first, count, {});
        }
    }
}

void Segmentation::summarize(const std::vector<std::uint32_t>& tiles, Smoothing smoothing) {
    gl::Program& program =
        summarize_.with(smoothing == Smoothing::Plain ? gl::Defines{{"VS_LOOSE", "1"}} : gl::Defines{});
    listTiles(tiles);
    texels_.bindTexture(kSegmentationTexture);
    cells_.bindImage(kCellsImage, gl::Access::Write);
    const auto total = std::uint32_t(tiles.size());
    for (std::uint32_t first = 0; first < total; first += gl::kMaxGroups) {
        program.set("dims", dims_)
            .set("brickDims", brickDims_)
            .set("tileDims", tileDims_)
            .set("firstTile", int(first))
            .set("cellDims", cells_.size());
        program.dispatch({1, int(std::min(gl::kMaxGroups, total - first)), 1}, gl::Barrier::Texture);
    }
}

Box3 Segmentation::update(const Growth& growth, Smoothing smoothing, const Looks& looks, double budgetMs,
                          const Fence& fence) {
    const gl::Pass pass("update segmentation");
    const bool isFenceStale = continuation_ && continuation_->isStale(fence);
    isBehind_ = budgetMs <= 0 && version_ > 0 && !startsAnew_ &&
                (isBehind_ || growth.revision() != seenRevision_ || looks != looks_ || isFenceStale);
    if (isBehind_) {
        return {};
    }
    std::vector<std::uint32_t> changed;
    try {
        changed = bringUpToDate(growth, smoothing, looks, budgetMs, fence);
    } catch (...) { // no room, or no memory
        startAnew();
        throw;
    }
    const bool isNewApart = apart_ && apart_->hasNew();
    version_ += !changed.empty() || isNewApart || startsAnew_ ? 1 : 0;
    Box3 box = std::exchange(startsAnew_, false) ? Box3{glm::ivec3(0), dims_} : Box3{};
    for (const std::uint32_t tile : changed) {
        const glm::ivec3 lo = tileAt(tile) * kTile;
        box = unite(box, {lo, glm::min(lo + kTile, dims_)});
    }
    if (apart_ && (!changed.empty() || isNewApart)) {
        try {
            writeApart(growth, fence, changed, smoothing);
        } catch (...) { // there may be no room for it; all else is as it has to be
            apart_->renewAll();
            throw;
        }
    }
    return box;
}

// All is made from nothing at the next update.
void Segmentation::startAnew() {
    startsAnew_ = true;
    channels_.clear();
    continuation_.reset();
    cells_.clear();
    seenRevision_ = 0;
    isBehind_ = false;
    if (apart_) {
        apart_->renewAll();
    }
}

// Returns the tiles that were written, each once.
std::vector<std::uint32_t> Segmentation::bringUpToDate(const Growth& growth, Smoothing smoothing,
                                                       const Looks& looks, double budgetMs,
                                                       const Fence& fence) {
    takeLooks(looks);
    const BrickTable& table = growth.seedMap().bricks();
    const auto bricks = haveLooksChanged_ ? table.occupied() : table.changedSince(seenRevision_);
    const auto continued = staleBehind(growth, fence, bricks);
    seenRevision_ = growth.revision();
    haveLooksChanged_ = false;
    std::vector<std::uint32_t> changed;
    for (int channel = 0; channel < int(channels_.size()); ++channel) {
        Channel& own = channels_[std::size_t(channel)];
        auto tiles = show(growth, channel, bricks);
        const auto behind = goOnBehind(growth, fence, own, continued);
        tiles.insert(tiles.end(), behind.begin(), behind.end());
        if (smoothing == Smoothing::Smooth) {
            queueTiles(own);
            tiles = smoothQueued(channel, budgetMs);
            isBehind_ = isBehind_ || !own.queue.empty();
        } else {
            tiles.insert(tiles.end(), own.queue.begin(),
                         own.queue.end()); // which are smoothed later all the same
            write(channel, tiles, smoothing);
        }
        changed.insert(changed.end(), tiles.begin(), tiles.end());
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    if (!changed.empty()) {
        summarize(changed, smoothing);
    }
    return changed;
}

std::size_t Segmentation::deviceBytes() const {
    const auto texels = [](const gl::Texture& texture) {
        const glm::i64vec3 size(texture.size());
        return std::size_t(size.x * size.y * size.z) * gl::bytesPerTexel(texture.format());
    };
    std::size_t bytes =
        texels(texels_) + texels(cells_) + tiles_.size() + reach_.size() + rows_.size() + alongXY_.size();
    bytes += apart_ ? apart_->deviceBytes() + labelsOfTiles_.size() : 0;
    for (const Channel& channel : channels_) {
        bytes += channel.shown.size() + channel.turned.size() + channel.owners.size();
    }
    bytes += turnedAlone_.size();
    return bytes;
}

std::vector<float> Segmentation::values() const {
    const auto texels = texels_.downloadAll<std::uint8_t>();
    const std::size_t stride = channels_.size();
    std::vector<float> values(texels.size() / stride);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = float(texels[stride * i]) / 255.0F;
    }
    return values;
}

} // namespace vs::segment
