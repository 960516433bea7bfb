// SPDX-License-Identifier: Apache-2.0
// Some segments each alone, where others touch them.
#include "gl/pass.h"
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
    bindMembers(channel);
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

// Label 0 is what goes on behind a cut, which is each segment's that is alone.
ApartTiles::Whose Segmentation::whoseIs(const Labels& labels, std::uint8_t label) {
    Labels others = labels;
    others[0] &= ~1U;
    others[label / 32] &= ~(1U << label % 32);
    const bool isOthers =
        std::any_of(others.begin(), others.end(), [](std::uint32_t word) { return word != 0; });
    const bool isOwn = (labels[label / 32] >> label % 32 & 1U) != 0 || (labels[0] & 1U) != 0;
    return isOwn ? (isOthers ? ApartTiles::Whose::BesideOthers : ApartTiles::Whose::Alone)
                 : (isOthers ? ApartTiles::Whose::Others : ApartTiles::Whose::Nobodys);
}

void Segmentation::writeApart(const Growth& growth, const std::vector<std::uint32_t>& changed,
                              Smoothing smoothing) {
    const gl::Pass pass("segments apart");
    growth.syncLabels();
    const gl::Texture& labels = growth.seedMap().labels();
    std::vector<std::uint32_t> everywhere;
    for (int channel = 0; channel < int(channels_.size()); ++channel) {
        Channel& own = channels_[std::size_t(channel)];
        noteLabels(own, changed, labels);
        for (const std::uint8_t label : apart_->labels()) {
            if (looks_[label] != Look(channel + 1)) {
                continue;
            }
            if (apart_->isNew(label) && everywhere.empty()) {
                everywhere.resize(own.labels.size());
                std::iota(everywhere.begin(), everywhere.end(), 0U);
            }
            const auto& tiles = apart_->isNew(label) ? everywhere : changed;
            std::vector<ApartTiles::Whose> whose(tiles.size());
            std::transform(tiles.begin(), tiles.end(), whose.begin(),
                           [&](std::uint32_t tile) { return whoseIs(own.labels[tile], label); });
            writeApart(channel, label, labels, apart_->place(label, tiles, whose), smoothing);
        }
    }
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
