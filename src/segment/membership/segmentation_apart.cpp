// SPDX-License-Identifier: Apache-2.0
// What tells each segment alone (field/shaders/one_segment.glsl).
#include "gl/pass.h"
#include "segment/membership/segmentation.h"
#include "segment/shaders/bindings.h"

#include <algorithm>

namespace vs::segment {

namespace {

constexpr std::size_t kLabelWords = 8; // of 32 bits, one for each label
constexpr std::uint32_t kLabels = 256;

} // namespace

void Segmentation::keepApart(bool isWanted) {
    if (isWanted == bool(apart_)) {
        return;
    }
    apart_ = {};
    for (Channel& channel : channels_) {
        channel.owners = {};
    }
    if (isWanted) {
        apart_ = gl::Texture(dims_, gl::Format::R8, gl::Filter::Linear, "segments apart");
        haveLooksChanged_ = true; // all has to be looked at once
    }
}

Segmentation::Reached Segmentation::reachedBySegments(int channel, const std::vector<std::uint32_t>& tiles,
                                                      const gl::Texture& labels) {
    listTiles(tiles);
    bindMembers(channels_[std::size_t(channel)]);
    labels.bindTexture(kLabelTexture);
    labelsOfTiles_.reserve(tiles.size() * kLabelWords * sizeof(std::uint32_t));
    labelsOfTiles_.bindStorage(kLabelsOfTilesStorage);
    gl::Defines defines = memberDefines();
    if (channel == 0) { // before anything is written
        defines.emplace_back("VS_CLEARS", "1");
        apart_.bindImage(kSegmentationImage, gl::Access::Write);
    }
    gl::Program& program = listLabels_.with(defines);
    const auto total = std::uint32_t(tiles.size());
    for (std::uint32_t first = 0; first < total; first += gl::kMaxGroups) {
        program.set("dims", dims_)
            .set("brickDims", brickDims_)
            .set("tileDims", tileDims_)
            .set("firstTile", int(first));
        program.dispatch({1, int(std::min(gl::kMaxGroups, total - first)), 1}, gl::Barrier::All);
    }
    const auto masks = labelsOfTiles_.read<std::uint32_t>(tiles.size() * kLabelWords);
    Reached reached;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const std::size_t first = reached.labels.size();
        for (std::uint32_t label = 1; label < kLabels; ++label) { // 0: what goes on behind a cut
            if ((masks[i * kLabelWords + label / 32] >> label % 32 & 1U) != 0) {
                reached.tiles.push_back(tiles[i]);
                reached.labels.push_back(label);
            }
        }
        for (std::size_t n = first; reached.labels.size() - first > 2 && n < reached.labels.size(); ++n) {
            reached.labels[n] += kCrowded;
        }
    }
    return reached;
}

void Segmentation::writeApart(const Growth& growth, const std::vector<std::uint32_t>& tiles,
                              Smoothing smoothing) {
    const gl::Pass pass("segments apart");
    growth.syncLabels();
    const gl::Texture& labels = growth.seedMap().labels();
    const bool isSmooth = smoothing == Smoothing::Smooth;
    for (int channel = 0; channel < int(channels_.size()); ++channel) {
        const Reached reached = isSmooth ? reachedBySegments(channel, tiles, labels) : Reached{tiles, {}};
        listTiles(reached.tiles);
        labelsOfTiles_.reserve(reached.labels.size() * sizeof(std::uint32_t));
        labelsOfTiles_.write(std::span<const std::uint32_t>(reached.labels));
        const auto total = std::uint32_t(reached.tiles.size());
        for (std::uint32_t first = 0; first < total; first += kTilesAtOnce) {
            const std::uint32_t count = std::min(kTilesAtOnce, total - first);
            labels.bindTexture(kLabelTexture);
            labelsOfTiles_.bindStorage(kLabelsOfTilesStorage);
            if (isSmooth) {
                smooth(channel, first, count, Of::Apart);
            } else {
                writePlain(channel, first, count, Of::Apart);
            }
        }
    }
}

} // namespace vs::segment
