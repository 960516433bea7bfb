// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/texture.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vs::sculpt {

// One change of a texture as the contents that certain bricks have on the other side of it. swap() goes there
// and, called again, back: undo and redo, byte for byte. Held as differences from what the texture has now
// (BrickEncoder); those may be kept elsewhere while they are not needed.
class BrickDelta {
public:
    // Exchanges the texture's contents with the ones held here; `texture` must be the one the delta was made
    // of, as it was then or as the last swap() left it. Throws Error or std::bad_alloc when there is no
    // memory to hold them; then nothing has changed.
    void swap(gl::Texture& texture);

    // For a delta that contentOf() made, and a texture in which every texel has the bytes `untouched`: brings
    // the contents into it. Costs half of what swap() does, which keeps what was there before.
    void bringInto(gl::Texture& texture, std::span<const std::byte> untouched) const;

    // What the texture would have in box() after swap(), as a texture of that size.
    [[nodiscard]] gl::Texture before(const gl::Texture& texture, const std::string& label) const;

    [[nodiscard]] bool isEmpty() const { return bricks_.empty(); }
    // The bricks in which something changed, as boxes of voxels, and the smallest box that holds them all.
    [[nodiscard]] const std::vector<Box3>& bricks() const { return bricks_; }
    [[nodiscard]] Box3 box() const;
    [[nodiscard]] std::size_t changedVoxels() const { return changedVoxels_; }
    [[nodiscard]] std::size_t memoryBytes() const;

    // The contents held, encoded: all that takes room. Whoever has copied them to a safe place may drop()
    // them and must giveBack() the same bytes before the next swap().
    [[nodiscard]] std::span<const std::byte> held() const { return held_; }
    void drop();
    void giveBack(std::vector<std::byte> held) { held_ = std::move(held); }

    // What files keep beside bricks() and changedVoxels(): where the encodings end in the contents held.
    [[nodiscard]] const std::vector<std::size_t>& ends() const { return ends_; }
    // One that was kept in a file, for a texture of that size. Throws Error when the parts do not fit each
    // other.
    static BrickDelta from(std::vector<Box3> bricks, std::vector<std::byte> held,
                           std::vector<std::size_t> ends, std::size_t changedVoxels, glm::ivec3 dims);

private:
    friend class DeltaMaker;
    [[nodiscard]] std::span<const Box3> together(std::size_t group) const;
    [[nodiscard]] std::span<const std::byte> encoding(std::size_t group) const;
    void exchange(gl::Texture& texture, std::size_t group, BrickDelta& other) const;

    std::vector<Box3> bricks_;
    std::vector<std::byte> held_;   // one encoding after the other, for kBricksTogether bricks each
    std::vector<std::size_t> ends_; // of those encodings in held_
    std::size_t changedVoxels_ = 0;
};

// What a texture holds in some bricks, as a delta that brings it into one in which every texel has the bytes
// `untouched`. Bricks that are untouched are left out.
BrickDelta contentOf(const gl::Texture& texture, std::span<const Box3> bricks,
                     std::span<const std::byte> untouched);
// All bricks (32^3) of a grid, x fastest.
std::vector<Box3> bricksOf(glm::ivec3 dims);

// Keeps the original contents of the bricks (32^3) of one texture from the moment they are about to be
// written for the first time. One backup lasts from the start of an operation to its end. Holds a reference
// to the texture.
class BrickBackup {
public:
    explicit BrickBackup(gl::Texture& texture) : texture_(&texture) {}

    // Call before anything inside `voxels` is written. Parts outside the texture are ignored.
    void protect(const Box3& voxels);
    // Puts every protected brick back as it was and goes on protecting them. Returns the box that may have
    // changed.
    Box3 restore();
    // Ends the operation: what differs now becomes a delta whose swap() undoes it, and the backup is empty
    // again. When there is no memory for that, it throws and protects as before.
    BrickDelta finish();

    [[nodiscard]] bool isEmpty() const { return originals_.empty(); }

private:
    struct Original {
        Box3 box;
        std::vector<std::byte> bytes;
    };
    gl::Texture* texture_;
    std::map<std::size_t, Original> originals_; // by brick number
};

} // namespace vs::sculpt
