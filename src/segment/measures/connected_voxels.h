// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vs::segment {

// One connected piece of a set (26 neighbours), its voxels numbered from 0 by z, then y, then x. What is kept
// for each voxel can so be as long as the piece and need not fill its box, of which a vessel is a small part.
// A place is a position in the set's tight box with a border of one voxel all around, x fastest. The box
// costs a bit and a half a voxel.
class ConnectedVoxels {
public:
    // The piece of `set` that the voxel `seed`, which must be in the set, belongs to.
    ConnectedVoxels(const VoxelSet& set, glm::ivec3 seed);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] bool contains(glm::ivec3 voxel) const;
    // The place of a voxel of the box, and the voxel at a place.
    [[nodiscard]] std::size_t placeOf(glm::ivec3 voxel) const;
    [[nodiscard]] glm::ivec3 voxelAt(std::size_t place) const;
    // The number of the piece's voxel at a place; elsewhere that of the next one.
    [[nodiscard]] std::uint32_t numberAt(std::size_t place) const {
        const std::uint64_t before = (std::uint64_t{1} << (place % 64)) - 1;
        return ranks_[place / 64] + std::uint32_t(std::popcount(words_[place / 64] & before));
    }
    // How much further along the places a neighbour is, x, y and z each from -1 to 1.
    [[nodiscard]] std::ptrdiff_t stepTo(glm::ivec3 neighbour) const {
        return neighbour.x + rowStep_ * neighbour.y + sliceStep_ * neighbour.z;
    }
    // Which of the three voxels at `place` and the two after it along x are in the piece: bits 0 to 2.
    [[nodiscard]] unsigned threeFrom(std::size_t place) const { return threeBits(words_, place); }

    // Calls visit(place) for each voxel of the piece in the order of their numbers.
    template <typename Visit>
    void forEachPlace(const Visit& visit) const {
        for (std::size_t word = 0; word < words_.size(); ++word) {
            for (std::uint64_t left = words_[word]; left != 0; left &= left - 1) {
                visit(64 * word + std::size_t(std::countr_zero(left)));
            }
        }
    }
    // Calls visit(place) for each voxel of the piece, the last number first.
    template <typename Visit>
    void forEachPlaceBackwards(const Visit& visit) const {
        for (std::size_t word = words_.size(); word-- > 0;) {
            for (std::uint64_t left = words_[word]; left != 0;) {
                const int last = 63 - std::countl_zero(left);
                visit(64 * word + std::size_t(last));
                left &= ~(std::uint64_t{1} << last);
            }
        }
    }

private:
    using Words = std::vector<std::uint64_t>;
    static unsigned threeBits(const Words& words, std::size_t place) {
        const std::size_t shift = place % 64;
        const std::uint64_t low = words[place / 64] >> shift;
        return unsigned(shift > 61 ? low | words[place / 64 + 1] << (64 - shift) : low) & 7U;
    }
    [[nodiscard]] Words bitsOf(const VoxelSet& set) const;
    void flood(Words left, std::size_t seed);
    void rank();

    Box3 box_; // with its border
    std::ptrdiff_t rowStep_ = 0;
    std::ptrdiff_t sliceStep_ = 0;
    Words words_;                      // a bit a place
    std::vector<std::uint32_t> ranks_; // how many voxels lie before each word
    std::size_t count_ = 0;
};

} // namespace vs::segment
