// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace vs::segment {

// One bit for each voxel of a tile of 8^3 voxels: eight slices along z, voxel (x, y) of a slice in bit
// x + 8 y. Internal to this folder.
struct Slices {
    std::array<std::uint64_t, 8> z{};

    [[nodiscard]] std::uint64_t any() const { return z[0] | z[1] | z[2] | z[3] | z[4] | z[5] | z[6] | z[7]; }
    Slices& operator&=(const Slices& other) {
        for (std::size_t i = 0; i < 8; ++i) {
            z[i] &= other.z[i];
        }
        return *this;
    }
    Slices& operator|=(const Slices& other) {
        for (std::size_t i = 0; i < 8; ++i) {
            z[i] |= other.z[i];
        }
        return *this;
    }
    // Takes away what the other has.
    Slices& operator-=(const Slices& other) {
        for (std::size_t i = 0; i < 8; ++i) {
            z[i] &= ~other.z[i];
        }
        return *this;
    }
};

namespace slices {

inline constexpr std::size_t kVoxels = 512;                     // of a tile
inline constexpr std::uint64_t kRow = 0xff;                     // the voxels of a slice with y = 0
inline constexpr std::uint64_t kColumn = 0x0101010101010101ULL; // those with x = 0

// A voxel of a tile, x + 8 y + 64 z.
constexpr std::uint32_t placeOf(glm::ivec3 inTile) {
    return std::uint32_t(inTile.x | inTile.y << 3 | inTile.z << 6);
}
constexpr glm::ivec3 voxelAt(std::uint32_t place) {
    return {int(place & 7U), int(place >> 3U & 7U), int(place >> 6U)};
}
constexpr bool has(const Slices& s, std::uint32_t place) {
    return (s.z[place >> 6U] >> (place & 63U) & 1U) != 0;
}
constexpr void set(Slices& s, std::uint32_t place) { s.z[place >> 6U] |= std::uint64_t(1) << (place & 63U); }
constexpr void clear(Slices& s, std::uint32_t place) {
    s.z[place >> 6U] &= ~(std::uint64_t(1) << (place & 63U));
}

// Calls f(place) for each voxel that is set.
template <typename F>
void forEach(const Slices& s, F&& f) {
    for (std::uint32_t z = 0; z < 8; ++z) {
        for (std::uint64_t left = s.z[z]; left != 0; left &= left - 1) {
            f(z << 6U | std::uint32_t(std::countr_zero(left)));
        }
    }
}

// Sides of a tile: bits 0 and 1 lower and upper x, 2 and 3 y, 4 and 5 z.
constexpr std::uint8_t sidesOf(bool beforeX, bool afterX, bool beforeY, bool afterY, bool beforeZ,
                               bool afterZ) {
    return std::uint8_t(int(beforeX) | int(afterX) << 1 | int(beforeY) << 2 | int(afterY) << 3 |
                        int(beforeZ) << 4 | int(afterZ) << 5);
}
// The sides that a voxel lies at.
inline constexpr auto kSidesAt = [] {
    std::array<std::uint8_t, kVoxels> sides{};
    for (std::uint32_t place = 0; place < kVoxels; ++place) {
        const glm::ivec3 v = voxelAt(place);
        sides[place] = sidesOf(v.x == 0, v.x == 7, v.y == 0, v.y == 7, v.z == 0, v.z == 7);
    }
    return sides;
}();

// The first `size` voxels along each axis.
inline Slices box(glm::ivec3 size) {
    const std::uint64_t row = (1ULL << unsigned(size.x)) - 1;
    const std::uint64_t rows = size.y == 8 ? ~0ULL : (1ULL << unsigned(8 * size.y)) - 1;
    Slices inside;
    for (std::size_t i = 0; i < std::size_t(size.z); ++i) {
        inside.z[i] = row * kColumn & rows;
    }
    return inside;
}

// Each voxel's neighbours in its slice along x, its own bits included; and along y.
constexpr std::uint64_t spreadX(std::uint64_t s) {
    return s | (s & ~(kColumn << 7U)) << 1U | (s & ~kColumn) >> 1U;
}
constexpr std::uint64_t spreadY(std::uint64_t s) { return s | s << 8U | s >> 8U; }
// What the slices beside one give it: those before and after along x, along y.
constexpr std::uint64_t fromX(std::uint64_t before, std::uint64_t after) {
    return (before >> 7U & kColumn) | (after & kColumn) << 7U;
}
constexpr std::uint64_t fromY(std::uint64_t before, std::uint64_t after) {
    return before >> 56U | after << 56U;
}

// --- the layout of the seed map (shaders/words.glsl): 16 words of 4 x 4 x 2 voxels

// Which of a tile's 512 numbers is a voxel's.
inline constexpr auto kNumberInSlice = [] {
    std::array<std::uint8_t, 64> numbers{};
    for (std::uint32_t bit = 0; bit < 64; ++bit) {
        const std::uint32_t x = bit & 7U;
        const std::uint32_t y = bit >> 3U;
        numbers[bit] = std::uint8_t((y >> 2U) << 6U | (x >> 2U) << 5U | (y & 3U) << 2U | (x & 3U));
    }
    return numbers;
}();
constexpr std::uint32_t numberOf(std::uint32_t place) {
    const std::uint32_t z = place >> 6U;
    return (z >> 1U) << 7U | (z & 1U) << 4U | kNumberInSlice[place & 63U];
}

// The left half (x below 4) of a slice: 16 bits of its lower rows, then of its upper ones.
constexpr std::uint32_t leftHalf(std::uint64_t slice) {
    std::uint64_t half = slice & 0x0f0f0f0f0f0f0f0fULL;
    half = (half | half >> 4U) & 0x00ff00ff00ff00ffULL;
    half = (half | half >> 8U) & 0x0000ffff0000ffffULL;
    return std::uint32_t(half | half >> 16U);
}
constexpr std::uint64_t fromLeftHalf(std::uint32_t rows) {
    std::uint64_t half = rows;
    half = (half | half << 16U) & 0x0000ffff0000ffffULL;
    half = (half | half << 8U) & 0x00ff00ff00ff00ffULL;
    return (half | half << 4U) & 0x0f0f0f0f0f0f0f0fULL;
}

Slices fromWords(const std::uint32_t* words);
void joinWords(const Slices& s, std::uint32_t* words);

} // namespace slices

} // namespace vs::segment
