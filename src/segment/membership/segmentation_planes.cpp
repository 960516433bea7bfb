// SPDX-License-Identifier: Apache-2.0
// Which voxels count in each channel: those shown, and those that segments are taken to have behind a fence.
#include "segment/membership/segmentation.h"

#include <algorithm>
#include <utility>

namespace vs::segment {

namespace {

constexpr std::uint32_t kSmoothedTilesPerBrick = 8;

// Of one bit a voxel, laid out as in shaders/words.glsl.
std::size_t planeBytes(glm::ivec3 dims) {
    const glm::ivec3 bricks = divideUp(dims, field::kBrick);
    constexpr std::size_t brickBytes = 4096;
    return (std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z) + 1) * brickBytes;
}

} // namespace

Looks allOpaque() {
    Looks looks;
    looks.fill(Look::Opaque);
    return looks;
}

// Makes the channels anew when there is to be another number of them.
void Segmentation::takeLooks(const Looks& looks) {
    const bool isGlass = std::find(looks.begin(), looks.end(), Look::Translucent) != looks.end();
    const std::size_t channels = isGlass ? 2 : 1;
    if (looks != looks_) {
        haveLooksChanged_ = true;
        if (apart_) {
            apart_->renewAll();
        }
    }
    looks_ = looks;
    if (channels == channels_.size()) {
        return;
    }
    isRemade_ = true;
    channels_.clear();
    texels_ = {}; // first, so that there is never room for both
    texels_ =
        gl::Texture(dims_, isGlass ? gl::Format::RG8 : gl::Format::R8, gl::Filter::Linear, "segmentation");
    std::vector<Channel> made;
    for (std::size_t i = 0; i < channels; ++i) {
        const auto tiles = std::size_t(tileDims_.x) * std::size_t(tileDims_.y) * std::size_t(tileDims_.z);
        made.push_back({gl::Buffer(planeBytes(dims_), "shown voxels"),
                        {},
                        {},
                        {},
                        std::vector<std::uint32_t>(tiles, 0),
                        {},
                        std::vector<bool>(tiles, false),
                        {}});
    }
    channels_ = std::move(made);
    haveLooksChanged_ = true;
}

// Brings the plane of what is shown in a channel up to date, and notes as pending where changes reach.
// Returns the tiles that changed.
std::vector<std::uint32_t> Segmentation::show(const Growth& growth, int channel,
                                              const std::vector<std::uint32_t>& bricks) {
    if (bricks.empty()) {
        return {};
    }
    Channel& own = channels_[std::size_t(channel)];
    std::vector<std::uint32_t> kinds;
    for (const Look look : looks_) {
        kinds.push_back(std::uint32_t(look));
    }
    if (apart_ && !own.owners) {
        own.owners = gl::Buffer(planeBytes(dims_), "owners of shown voxels");
    }
    clearReach(bricks);
    growth.show(own.shown, reach_, bricks, kinds, std::uint32_t(channel + 1),
                own.owners ? &own.owners : nullptr);
    return takeReach(growth.seedMap().bricks(), own, bricks);
}

// Where segments have to be continued again.
std::vector<std::uint32_t> Segmentation::staleBehind(const Growth& growth, const Fence& fence,
                                                     const std::vector<std::uint32_t>& changed) {
    if (!continuation_ && !Continuation::isNeeded(growth, fence)) {
        return {};
    }
    if (!continuation_) {
        continuation_.emplace(dims_);
    }
    for (Channel& channel : channels_) {
        if (!channel.turned) {
            channel.turned = gl::Buffer(planeBytes(dims_), "turned voxels");
        }
    }
    return continuation_->refresh(growth, fence, changed, haveLooksChanged_);
}

// As show(), for what segments are taken to be behind the fence.
std::vector<std::uint32_t> Segmentation::goOnBehind(const Growth& growth, const Fence& fence,
                                                    Channel& channel,
                                                    const std::vector<std::uint32_t>& bricks) {
    if (bricks.empty()) {
        return {};
    }
    clearReach(bricks);
    continuation_->run(growth, fence, channel.shown, channel.turned, reach_, bricks);
    return takeReach(growth.seedMap().bricks(), channel, bricks);
}

void Segmentation::clearReach(const std::vector<std::uint32_t>& bricks) {
    reach_.reserve(bricks.size() * kSmoothedTilesPerBrick * sizeof(std::uint32_t));
    reach_.clear();
}

std::vector<std::uint32_t> Segmentation::takeReach(const BrickTable& table, Channel& channel,
                                                   const std::vector<std::uint32_t>& bricks) {
    const auto reach = reach_.read<std::uint32_t>(bricks.size() * kSmoothedTilesPerBrick);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t i = 0; i < reach.size(); ++i) {
        if (reach[i] != 0) {
            const glm::ivec3 first = table.box(bricks[i / kSmoothedTilesPerBrick]).lo / kTile;
            const auto tile = tileIndex(first + glm::ivec3(i & 1U, i >> 1 & 1U, i >> 2 & 1U));
            channel.pending[tile] |= reach[i];
            changed.push_back(tile);
        }
    }
    return changed;
}

} // namespace vs::segment
