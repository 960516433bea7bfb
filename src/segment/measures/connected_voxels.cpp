// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/connected_voxels.h"

#include "base/check.h"
#include "base/progress.h"

#include <algorithm>
#include <utility>

namespace vs::segment {

ConnectedVoxels::ConnectedVoxels(const VoxelSet& set, glm::ivec3 seed)
    : box_(grow(set.tightBox(), 1)), rowStep_(box_.size().x),
      sliceStep_(std::ptrdiff_t(box_.size().x) * box_.size().y) {
    VS_CHECK(set.contains(seed));
    reportProgress();
    flood(bitsOf(set), placeOf(seed));
    rank();
}

bool ConnectedVoxels::contains(glm::ivec3 voxel) const {
    if (glm::any(glm::lessThan(voxel, box_.lo)) || glm::any(glm::greaterThanEqual(voxel, box_.hi))) {
        return false;
    }
    const std::size_t place = placeOf(voxel);
    return (words_[place / 64] >> (place % 64) & 1) != 0;
}

std::size_t ConnectedVoxels::placeOf(glm::ivec3 voxel) const { return std::size_t(stepTo(voxel - box_.lo)); }

glm::ivec3 ConnectedVoxels::voxelAt(std::size_t place) const {
    const auto row = std::ptrdiff_t(place) / rowStep_;
    const int y = int(row % box_.size().y);
    return box_.lo + glm::ivec3(int(std::ptrdiff_t(place) % rowStep_), y, int(row / box_.size().y));
}

ConnectedVoxels::Words ConnectedVoxels::bitsOf(const VoxelSet& set) const {
    Words words(box_.volume() / 64 + 2, 0); // three bits can be asked for at the last place
    const Box3 tight = grow(box_, -1);
    for (int z = tight.lo.z; z < tight.hi.z; ++z) {
        for (int y = tight.lo.y; y < tight.hi.y; ++y) {
            const std::uint8_t* const row = set.inside.data() + set.indexOf({tight.lo.x, y, z});
            const std::uint8_t* const end = row + tight.size().x;
            const std::size_t first = placeOf({tight.lo.x, y, z});
            for (const std::uint8_t* at = std::find(row, end, 1); at != end; ++at) {
                const std::size_t place = first + std::size_t(at - row);
                words[place / 64] |= std::uint64_t(*at) << (place % 64);
            }
        }
    }
    return words;
}

// Moves what can be reached from `seed` over from `left`.
void ConnectedVoxels::flood(Words left, std::size_t seed) {
    words_.assign(left.size(), 0);
    const auto move = [&](std::size_t place) {
        left[place / 64] &= ~(std::uint64_t{1} << (place % 64));
        words_[place / 64] |= std::uint64_t{1} << (place % 64);
        ++count_;
    };
    std::vector<std::size_t> open{seed};
    move(seed);
    while (!open.empty()) {
        const std::size_t place = open.back();
        open.pop_back();
        for (int row = 0; row < 9; ++row) {
            const auto first = std::size_t(std::ptrdiff_t(place) + stepTo({-1, row % 3 - 1, row / 3 - 1}));
            for (unsigned found = threeBits(left, first); found != 0; found &= found - 1) {
                const std::size_t next = first + std::size_t(std::countr_zero(found));
                move(next);
                open.push_back(next);
            }
        }
    }
}

void ConnectedVoxels::rank() {
    ranks_.reserve(words_.size());
    std::uint32_t before = 0;
    for (const std::uint64_t word : words_) {
        ranks_.push_back(before);
        before += std::uint32_t(std::popcount(word));
    }
}

} // namespace vs::segment
