// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/segmentation.h"

#include "base/progress.h"
#include "base/timer.h"
#include "field/cell_ranges.h"
#include "gl/context.h"
#include "gl/pass.h"
#include "segment/membership/membership.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <iterator>
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
    changedAt_.assign(std::size_t(tileDims_.x) * std::size_t(tileDims_.y) * std::size_t(tileDims_.z), 0);
    takeLooks(allOpaque());
    isRemade_ = false;
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

// Segments are to be continued in these bricks.
void Segmentation::owe(Channel& channel, const std::vector<std::uint32_t>& bricks) {
    std::vector<std::uint32_t> both;
    std::set_union(channel.owed.begin(), channel.owed.end(), bricks.begin(), bricks.end(),
                   std::back_inserter(both));
    channel.owed = std::move(both);
}

// Continues segments, where that is owed, in the bricks that the first tiles of the queue look at; everywhere
// when these are all, or there are none. What changes by that is queued.
void Segmentation::continueOwed(const Growth& growth, const Fence& fence, Channel& channel,
                                std::size_t tiles) {
    if (channel.owed.empty()) {
        return;
    }
    std::vector<bool> isNear(std::size_t(brickDims_.x) * std::size_t(brickDims_.y) *
                                 std::size_t(brickDims_.z),
                             tiles == channel.queue.size());
    for (std::size_t i = 0; i < tiles; ++i) {
        const glm::ivec3 lo = tileAt(channel.queue[i]) * kTile;
        const Box3 seen = intersect(grow({lo, lo + kTile}, kKernelReach), {glm::ivec3(0), dims_});
        forEachVoxel({seen.lo / field::kBrick, divideUp(seen.hi, field::kBrick)},
                     [&](glm::ivec3 b, std::size_t) {
                         isNear[std::size_t((b.z * brickDims_.y + b.y) * brickDims_.x + b.x)] = true;
                     });
    }
    const auto firstLeft = std::stable_partition(channel.owed.begin(), channel.owed.end(),
                                                 [&](std::uint32_t brick) { return isNear[brick]; });
    const std::vector<std::uint32_t> bricks(channel.owed.begin(), firstLeft);
    goOnBehind(growth, fence, channel, bricks);
    channel.owed.erase(channel.owed.begin(), channel.owed.begin() + std::ptrdiff_t(bricks.size()));
    queueTiles(channel);
}

// Returns the tiles that were smoothed.
std::vector<std::uint32_t> Segmentation::smoothQueued(const Growth& growth, const Fence& fence, int channel,
                                                      double budgetMs) {
    const Timer timer;
    Channel& own = channels_[std::size_t(channel)];
    const bool isHurried = budgetMs < kNoHurry;
    std::vector<std::uint32_t> done;
    const auto next = [&] { // tiles, before the clock is read again
        constexpr std::size_t kAtOnce = 32;
        return isHurried ? std::min(kAtOnce, own.queue.size()) : own.queue.size();
    };
    while ((!own.queue.empty() || !own.owed.empty()) && (done.empty() || timer.milliseconds() < budgetMs)) {
        continueOwed(growth, fence, own, next());
        const auto end = own.queue.begin() + std::ptrdiff_t(next());
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
    version_ += isNewApart ? 1 : 0;
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
        owe(own, continued);
        if (smoothing == Smoothing::Smooth) {
            queueTiles(own);
            tiles = smoothQueued(growth, fence, channel, budgetMs);
            isBehind_ = isBehind_ || !own.queue.empty() || !own.owed.empty();
        } else {
            const auto behind = goOnBehind(growth, fence, own, std::exchange(own.owed, {}));
            tiles.insert(tiles.end(), behind.begin(), behind.end());
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
    const bool areColoured = growth.hasOthers(); // else all have one colour, and labels may lag behind
    const bool hasAllChanged = startsAnew_ || isRemade_ || areColoured != wereColoured_;
    noteChanged(changed, areColoured ? bricks : std::vector<std::uint32_t>(), table, hasAllChanged);
    isRemade_ = false;
    wereColoured_ = areColoured;
    return changed;
}

// Tiles whose memberships were written, and bricks where voxels may have another colour.
void Segmentation::noteChanged(const std::vector<std::uint32_t>& tiles,
                               const std::vector<std::uint32_t>& recoloured, const BrickTable& table,
                               bool hasAllChanged) {
    if (tiles.empty() && recoloured.empty() && !hasAllChanged) {
        return;
    }
    ++version_;
    if (hasAllChanged) {
        std::fill(changedAt_.begin(), changedAt_.end(), version_);
    }
    for (const std::uint32_t tile : tiles) {
        changedAt_[tile] = version_;
    }
    for (const std::uint32_t brick : recoloured) {
        const Box3 box = table.box(brick);
        forEachVoxel({box.lo / kTile, divideUp(box.hi, kTile)},
                     [&](glm::ivec3 tile, std::size_t) { changedAt_[tileIndex(tile)] = version_; });
    }
}

Box3 Segmentation::changedSince(std::uint64_t version) const {
    Box3 box;
    for (std::uint32_t tile = 0; tile < changedAt_.size(); ++tile) {
        if (changedAt_[tile] > version) {
            const glm::ivec3 lo = tileAt(tile) * kTile;
            box = unite(box, {lo, glm::min(lo + kTile, dims_)});
        }
    }
    return box;
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

void updateWholly(Segmentation& segmentation, const Growth& growth, const Looks& looks) {
    constexpr double kPortionMs = 100; // between asking whether to go on
    do {
        segmentation.update(growth, Smoothing::Smooth, looks, kPortionMs);
        reportProgress();
    } while (segmentation.isBehind());
}

} // namespace vs::segment
