// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "field/bricks/brick_overlay.h"
#include "gl/texture.h"

#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace vs::field {

// Bricks on the device: slots of one size in one texture. When all are taken, the brick goes that was used
// least recently, but none of those that are in use now.
class BrickPool {
public:
    // Makes slots of texels^3: so many as the bytes and the device have room for, `most` at the most. Throws
    // GlError when the device has room for hardly any.
    // Each slot has room for as many texels of each layer that has a format, which are zero at first.
    BrickPool(int texels, gl::Format format, std::size_t bytes, std::size_t most,
              const LayerFormats& layers = {});

    // How many slots that would be, as far as the budget and the limits of a texture say.
    static std::size_t slotsFor(int texels, gl::Format format, std::size_t bytes, std::size_t most,
                                const LayerFormats& layers = {});

    [[nodiscard]] std::size_t slotCount() const;
    [[nodiscard]] glm::ivec3 slotCounts() const { return counts_; } // along each axis
    [[nodiscard]] const gl::Texture& texture() const { return texture_; }
    // Null where the layer has no room.
    [[nodiscard]] const gl::Texture& overlay(BrickLayer layer) const {
        return over_[std::size_t(layer)].texture;
    }
    [[nodiscard]] std::size_t bytes() const;
    // Whether a brick lies in every slot.
    [[nodiscard]] bool isFull() const { return free_.empty(); }

    // Where a brick lies, in slots; nothing: it is not there.
    [[nodiscard]] std::optional<glm::ivec3> find(const BrickKey& key) const;
    // Calls visit(key, slot) with each brick that is there.
    template <typename Visit>
    void forEach(const Visit& visit) const {
        for (const auto& [key, brick] : bricks_) {
            visit(key, brick.slot);
        }
    }
    // What is used from here on is in use now, what was used before is not.
    void beginRound() { ++round_; }
    void use(const BrickKey& key);
    struct Put {
        glm::ivec3 slot{0};
        std::optional<BrickKey> goneInstead;
    };
    // Puts a brick's texels there. Nothing: every slot is in use.
    std::optional<Put> put(const BrickKey& key, std::span<const std::byte> texels);
    // Lays that over a brick that is there; no texels: zeros.
    void lay(BrickLayer layer, const BrickKey& key, std::span<const std::byte> texels);

private:
    struct Brick {
        glm::ivec3 slot{0};
        std::uint64_t round = 0; // in which it was used last
        std::list<BrickKey>::iterator order;
    };
    [[nodiscard]] Box3 boxOf(glm::ivec3 slot) const;

    int texels_;
    glm::ivec3 counts_{0}; // slots along each axis
    gl::Texture texture_;
    struct Over {
        gl::Texture texture;
        std::set<std::array<int, 3>> laid; // slots where it is not all zero
    };
    OfBrickLayers<Over> over_;
    std::vector<glm::ivec3> free_;
    std::map<BrickKey, Brick> bricks_;
    std::list<BrickKey> order_; // the one used last first
    std::uint64_t round_ = 1;
};

} // namespace vs::field
