// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace vs::sculpt {

// Bricks as differences, for undo: what the texels of a box were, told to someone who has what they are now.
// Texels are single numbers of 1, 2 or 4 bytes whose bit patterns, read as integers, follow their values
// (unsigned integers, or floats that are not negative); x fastest.
//
// A bit a texel says which differ. Those that do are predicted from their neighbours before them in x, y and
// z (a sculpture is smooth), and what the prediction missed is kept, high bytes apart from low ones. All of
// it goes through zstd. Several bricks share one encoding, so that small ones do not pay for tables of their
// own.
class BrickEncoder {
public:
    explicit BrickEncoder(std::size_t texelBytes);

    // Adds the next brick, of `size` texels: `held` is what is to be kept, `current` what the decoder will
    // have. Returns how many texels differ.
    std::size_t add(glm::ivec3 size, std::span<const std::byte> held, std::span<const std::byte> current);
    // All bricks added, encoded. Throws Error when there is no memory for it.
    [[nodiscard]] std::vector<std::byte> finish() const;

private:
    std::size_t texelBytes_;
    std::vector<std::byte> changed_; // one bit a texel, each row from a byte of its own on
    std::array<std::vector<std::byte>, 4> planes_;
};

class BrickDecoder {
public:
    // `encoded` is what finish() of an encoder of the same texelBytes gave; it is not needed any more later.
    // Throws Error, as next() does, when it is damaged.
    BrickDecoder(std::size_t texelBytes, std::span<const std::byte> encoded);

    // Decodes the next brick, in the order and of the size in which they were added: turns `texels` from what
    // `current` was there into what `held` was.
    void next(glm::ivec3 size, std::span<std::byte> texels);

private:
    std::size_t texelBytes_;
    std::vector<std::byte> changed_;
    std::array<std::vector<std::byte>, 4> planes_;
    std::size_t changedAt_ = 0;
    std::size_t planeAt_ = 0;
};

} // namespace vs::sculpt
