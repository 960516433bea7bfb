// SPDX-License-Identifier: Apache-2.0
// Some segments each alone, where others touch them.
#include "field/cell_ranges.h"
#include "gl/pass.h"
#include "segment/membership/membership.h"
#include "segment/membership/segmentation.h"
#include "segment/shaders/bindings.h"

#include <algorithm>
#include <numeric>

namespace vs::segment {

void Segmentation::keepApart(const std::vector<std::uint8_t>& labels) {
    if (labels.empty() == !apart_) {
        if (apart_) {
            apart_->keep(labels);
        }
        return;
    }
    apart_.reset();
    turnedAlone_ = {};
    for (Channel& channel : channels_) {
        channel.owners = {};
        channel.labels.clear();
    }
    if (!labels.empty()) {
        apart_.emplace(tileDims_);
        apart_->keep(labels);
        haveLooksChanged_ = true; // all has to be looked at once
    }
}

// Which labels reach tiles of a channel, as its words.
void Segmentation::noteLabels(Channel& channel, const std::vector<std::uint32_t>& tiles,
                              const gl::Texture& labels) {
    channel.labels.resize(channel.pending.size());
    listTiles(tiles);
    bindMembers(channel, {});
    labels.bindTexture(kLabelTexture);
    labelsOfTiles_.reserve(tiles.size() * sizeof(Labels));
    labelsOfTiles_.bindStorage(kLabelsOfTilesStorage);
    gl::Program& program = listLabels_.with(memberDefines());
    const auto total = std::uint32_t(tiles.size());
    for (std::uint32_t first = 0; first < total; first += gl::kMaxGroups) {
        program.set("dims", dims_)
            .set("brickDims", brickDims_)
            .set("tileDims", tileDims_)
            .set("firstTile", int(first));
        program.dispatch({1, int(std::min(gl::kMaxGroups, total - first)), 1}, gl::Barrier::All);
    }
    const auto found = labelsOfTiles_.read<Labels>(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        channel.labels[tiles[i]] = found[i];
    }
}

namespace {

bool has(const Segmentation::Labels& labels, std::uint8_t label) {
    return (labels[label / 32] >> label % 32 & 1U) != 0;
}

} // namespace

// Calls `visit` with those of the 27 tiles around one, itself included, that there are.
template <typename Visit>
void Segmentation::visitAround(std::uint32_t tile, const Visit& visit) const {
    for (int n = 0; n < 27; ++n) {
        const glm::ivec3 there = tileAt(tile) + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
        if (glm::all(glm::greaterThanEqual(there, glm::ivec3(0))) &&
            glm::all(glm::lessThan(there, tileDims_))) {
            visit(tileIndex(there));
        }
    }
}

// What goes on behind a cut has no label, and may be of any segment close by.
ApartTiles::Whose Segmentation::whoseIs(const Channel& channel, std::uint32_t tile,
                                        std::uint8_t label) const {
    const Labels& labels = channel.labels[tile];
    const bool goesOn = has(labels, 0);
    Labels others = labels;
    others[0] &= ~1U;
    others[label / 32] &= ~(1U << label % 32);
    const bool isOthers =
        goesOn || std::any_of(others.begin(), others.end(), [](auto word) { return word != 0; });
    bool isOwn = has(labels, label);
    if (goesOn && !isOwn) {
        visitAround(tile, [&](std::uint32_t there) { isOwn = isOwn || has(channel.labels[there], label); });
    }
    return isOwn ? (isOthers ? ApartTiles::Whose::BesideOthers : ApartTiles::Whose::Alone)
                 : (isOthers ? ApartTiles::Whose::Others : ApartTiles::Whose::Nobodys);
}

// The changed tiles, and of those around them in which segments go on behind a cut those that are no longer
// whose they were.
std::vector<std::uint32_t> Segmentation::staleApart(const Channel& channel, std::uint8_t label,
                                                    const std::vector<std::uint32_t>& changed) const {
    std::vector<std::uint32_t> stale = changed;
    if (!continuation_) {
        return stale;
    }
    for (const std::uint32_t tile : changed) {
        visitAround(tile, [&](std::uint32_t there) {
            if (has(channel.labels[there], 0) &&
                whoseIs(channel, there, label) != apart_->whose(label, there)) {
                stale.push_back(there);
            }
        });
    }
    std::sort(stale.begin(), stale.end());
    stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
    return stale;
}

void Segmentation::writeApart(const Growth& growth, const Fence& fence,
                              const std::vector<std::uint32_t>& changed, Smoothing smoothing) {
    const gl::Pass pass("segments apart");
    growth.syncLabels();
    const gl::Texture& labels = growth.seedMap().labels();
    std::vector<std::uint32_t> everywhere(channels_.front().pending.size());
    std::iota(everywhere.begin(), everywhere.end(), 0U);
    for (int channel = 0; channel < int(channels_.size()); ++channel) {
        Channel& own = channels_[std::size_t(channel)];
        noteLabels(own, changed, labels);
        for (const std::uint8_t label : apart_->labels()) {
            if (looks_[label] != Look(channel + 1)) {
                continue;
            }
            const auto tiles = apart_->isNew(label) ? everywhere : staleApart(own, label, changed);
            std::vector<ApartTiles::Whose> whose(tiles.size());
            std::transform(tiles.begin(), tiles.end(), whose.begin(),
                           [&](std::uint32_t tile) { return whoseIs(own, tile, label); });
            const auto changes = apart_->place(label, tiles, whose);
            goOnAlone(growth, fence, own, label, changes.own);
            writeApart(channel, label, labels, changes, smoothing);
        }
    }
}

// What one segment is taken to be behind cuts when no other is shown, around some tiles.
void Segmentation::goOnAlone(const Growth& growth, const Fence& fence, const Channel& channel,
                             std::uint8_t label, const std::vector<std::uint32_t>& tiles) {
    if (!continuation_ || tiles.empty()) {
        return;
    }
    if (!turnedAlone_) {
        turnedAlone_ = gl::Buffer(channel.turned.size(), "turned voxels of a segment alone");
    }
    const BrickTable& table = growth.seedMap().bricks();
    std::vector<bool> isWanted(table.count(), false);
    for (const std::uint32_t tile : tiles) {
        const glm::ivec3 lo = tileAt(tile) * kTile;
        const Box3 reached = intersect(grow({lo, lo + kTile}, kKernelReach), {glm::ivec3(0), dims_});
        const Box3 bricks{reached.lo / field::kBrick, divideUp(reached.hi, field::kBrick)};
        for (int z = bricks.lo.z; z < bricks.hi.z; ++z) {
            for (int y = bricks.lo.y; y < bricks.hi.y; ++y) {
                for (int x = bricks.lo.x; x < bricks.hi.x; ++x) {
                    isWanted[std::size_t((z * brickDims_.y + y) * brickDims_.x + x)] = true;
                }
            }
        }
    }
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t brick = 0; brick < table.count(); ++brick) {
        if (isWanted[brick]) {
            bricks.push_back(brick);
        }
    }
    clearReach(bricks);
    continuation_->run(growth, fence, channel.shown, turnedAlone_, reach_, bricks, label);
}

void Segmentation::writeApart(int channel, std::uint8_t label, const gl::Texture& labels,
                              const ApartTiles::Changes& changes, Smoothing smoothing) {
    listTiles(changes.own);
    labelsOfTiles_.reserve(changes.own.size() * sizeof(std::uint32_t));
    labelsOfTiles_.write(std::span<const std::uint32_t>(changes.pagesOfOwn));
    const auto own = std::uint32_t(changes.own.size());
    for (std::uint32_t first = 0; first < own; first += kTilesAtOnce) {
        labels.bindTexture(kLabelTexture);
        labelsOfTiles_.bindStorage(kPagesOfTilesStorage);
        const Of of{label, true};
        if (smoothing == Smoothing::Smooth) {
            smooth(channel, first, std::min(kTilesAtOnce, own - first), of);
        } else {
            writePlain(channel, first, std::min(kTilesAtOnce, own - first), of);
        }
    }
    if (changes.incomplete.empty()) {
        return;
    }
    if (!completeTiles_) {
        completeTiles_ = gl::Program("segment/shaders/complete_tiles.comp");
    }
    listTiles(changes.incomplete);
    texels_.bindTexture(kSegmentationTexture);
    apart_->pages(label).bindTexture(kPagesTexture);
    apart_->texels().bindImage(kSegmentationImage, gl::Access::ReadWrite);
    const auto total = std::uint32_t(changes.incomplete.size());
    for (std::uint32_t first = 0; first < total; first += gl::kMaxGroups) {
        completeTiles_.set("tileDims", tileDims_).set("firstTile", int(first)).set("channel", channel);
        completeTiles_.dispatch({1, int(std::min(gl::kMaxGroups, total - first)), 1}, gl::Barrier::Texture);
    }
}

} // namespace vs::segment
