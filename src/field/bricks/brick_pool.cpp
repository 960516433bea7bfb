// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_pool.h"

#include "base/check.h"
#include "base/error.h"
#include "gl/limits.h"

#include <algorithm>
#include <cmath>

namespace vs::field {

namespace {

constexpr std::size_t kMostBytes =
    (std::size_t(2) << 30) - (std::size_t(64) << 20); // of one texture of llvmpipe
constexpr std::size_t kFewSlots = 64;

// A box of slots, about as wide as it is high and deep, of no more than so many in all.
glm::ivec3 slotsAlong(std::size_t slots, int mostAlong) {
    const int side = std::clamp(int(std::cbrt(double(slots))), 1, mostAlong);
    glm::ivec3 counts(side);
    counts.y = std::clamp(int(slots / std::size_t(side * side)), 1, mostAlong);
    counts.z = std::clamp(int(slots / (std::size_t(side) * std::size_t(counts.y))), 1, mostAlong);
    return counts;
}

// Page tables have ten bits for a slot's place along an axis.
int mostAlong(int texels) { return std::clamp(gl::limits().texture3D / texels, 1, 1023); }

std::size_t countOf(glm::ivec3 slots) {
    return std::size_t(slots.x) * std::size_t(slots.y) * std::size_t(slots.z);
}

} // namespace

std::size_t BrickPool::slotsFor(int texels, gl::Format format, std::size_t bytes, std::size_t most,
                                const LayerFormats& layers) {
    const std::size_t texelsOfSlot = std::size_t(texels) * std::size_t(texels) * std::size_t(texels);
    std::size_t all = gl::bytesPerTexel(format);
    std::size_t widest = all;
    for (const std::optional<gl::Format>& layer : layers) {
        const std::size_t over = layer ? gl::bytesPerTexel(*layer) : 0;
        all += over;
        widest = std::max(widest, over);
    }
    const std::size_t slots =
        std::clamp<std::size_t>(std::min(bytes / (texelsOfSlot * all), kMostBytes / (texelsOfSlot * widest)),
                                1, std::max<std::size_t>(most, 1));
    return countOf(slotsAlong(slots, mostAlong(texels)));
}

BrickPool::BrickPool(int texels, gl::Format format, std::size_t bytes, std::size_t most,
                     const LayerFormats& layers)
    : texels_(texels) {
    std::size_t slots = slotsFor(texels, format, bytes, most, layers);
    while (!texture_) {
        counts_ = slotsAlong(slots, mostAlong(texels));
        try {
            for (std::size_t i = 0; i < layers.size(); ++i) {
                over_[i].texture =
                    layers[i] ? gl::Texture(counts_ * texels, *layers[i], gl::Filter::Linear, "over bricks")
                              : gl::Texture();
            }
            texture_ = gl::Texture(counts_ * texels, format, gl::Filter::Linear, "bricks");
        } catch (const GlError&) {
            if (slots <= kFewSlots) {
                throw;
            }
            slots /= 2; // the budget is what is allowed, and may be more than there is
        }
    }
    forEachVoxel({glm::ivec3(0), counts_}, [&](glm::ivec3 slot, std::size_t) { free_.push_back(slot); });
    std::reverse(free_.begin(), free_.end());
}

std::size_t BrickPool::slotCount() const { return countOf(counts_); }

std::size_t BrickPool::bytes() const {
    std::size_t perTexel = gl::bytesPerTexel(texture_.format());
    for (const Over& over : over_) {
        perTexel += over.texture ? gl::bytesPerTexel(over.texture.format()) : 0;
    }
    return Box3{glm::ivec3(0), texture_.size()}.volume() * perTexel;
}

Box3 BrickPool::boxOf(glm::ivec3 slot) const { return {slot * texels_, (slot + 1) * texels_}; }

std::optional<glm::ivec3> BrickPool::find(const BrickKey& key) const {
    const auto found = bricks_.find(key);
    return found == bricks_.end() ? std::nullopt : std::optional(found->second.slot);
}

void BrickPool::use(const BrickKey& key) {
    const auto found = bricks_.find(key);
    if (found != bricks_.end()) {
        found->second.round = round_;
        order_.splice(order_.begin(), order_, found->second.order);
    }
}

void BrickPool::lay(BrickLayer layer, const BrickKey& key, std::span<const std::byte> texels) {
    Over& over = over_[std::size_t(layer)];
    const glm::ivec3 slot = bricks_.at(key).slot;
    const std::array<int, 3> at{slot.x, slot.y, slot.z};
    if (!texels.empty()) {
        over.texture.upload(boxOf(slot), texels);
        over.laid.insert(at);
    } else if (over.laid.erase(at) > 0) {
        over.texture.clear(boxOf(slot));
    }
}

std::optional<BrickPool::Put> BrickPool::put(const BrickKey& key, std::span<const std::byte> texels) {
    VS_CHECK(!bricks_.contains(key));
    Put put;
    if (!free_.empty()) {
        put.slot = free_.back();
        free_.pop_back();
    } else {
        const auto oldest = bricks_.find(order_.back());
        if (oldest->second.round == round_) {
            return {};
        }
        put.slot = oldest->second.slot;
        put.goneInstead = oldest->first;
        order_.pop_back();
        bricks_.erase(oldest);
    }
    texture_.upload(boxOf(put.slot), texels);
    order_.push_front(key);
    bricks_[key] = {put.slot, round_, order_.begin()};
    return put;
}

} // namespace vs::field
