// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/brick_ranges.h"

#include "base/math.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace vs::field {

namespace {

// The upper half of a float, which is the next one further from zero or nearer to it.
std::uint32_t upperHalf(float value, bool awayFromZero) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const bool isExact = (bits & 0xffffU) == 0;
    return (bits >> 16) + (awayFromZero && !isExact ? 1U : 0U);
}

// Smallest and largest texels of the cells of a brick.
template <typename T>
struct Extremes {
    explicit Extremes(std::size_t count)
        : lo(count, std::numeric_limits<T>::max()), hi(count, std::numeric_limits<T>::lowest()) {}
    void add(std::size_t to, const Extremes& other, std::size_t from) {
        lo[to] = std::min(lo[to], other.lo[from]);
        hi[to] = std::max(hi[to], other.hi[from]);
    }
    std::vector<T> lo;
    std::vector<T> hi;
};

// A place belongs to one cell along an axis, or to two where these meet.
struct Cells {
    int first;
    int last;
};
Cells cellsAt(int place, int count) {
    const int cell = place / kBrickCell;
    return {place % kBrickCell == 0 ? std::max(cell - 1, 0) : cell, std::min(cell, count - 1)};
}

template <typename T>
void addRow(const T* row, int side, Extremes<T>& cells) {
    for (std::size_t cell = 0; cell < cells.lo.size(); ++cell) {
        const T* begin = row + cell * kBrickCell;
        const T* end = row + std::min(int(cell + 1) * kBrickCell, side) + 1;
        T lo = *begin;
        T hi = *begin;
        for (const T* texel = begin + 1; texel != end; ++texel) {
            lo = std::min(lo, *texel);
            hi = std::max(hi, *texel);
        }
        cells.lo[cell] = lo;
        cells.hi[cell] = hi;
    }
}

template <typename T>
Extremes<T> extremesOf(const T* texels, int side) {
    const auto along = std::size_t(side) + 1;
    const int count = cellsAlong(side);
    const auto n = std::size_t(count);
    Extremes<T> cells(n * n * n);
    Extremes<T> row(n);
    Extremes<T> plane(n * n);
    for (int z = 0; z <= side; ++z) {
        plane = Extremes<T>(n * n);
        for (int y = 0; y <= side; ++y) {
            addRow(texels + (std::size_t(z) * along + std::size_t(y)) * along, side, row);
            const Cells high = cellsAt(y, count);
            for (int j = high.first; j <= high.last; ++j) {
                for (std::size_t i = 0; i < n; ++i) {
                    plane.add(std::size_t(j) * n + i, row, i);
                }
            }
        }
        const Cells deep = cellsAt(z, count);
        for (int k = deep.first; k <= deep.last; ++k) {
            for (std::size_t i = 0; i < n * n; ++i) {
                cells.add(std::size_t(k) * n * n + i, plane, i);
            }
        }
    }
    return cells;
}

template <typename T>
BrickRanges rangesOf(const T* texels, int side, float scale, float offset) {
    const Extremes<T> cells = extremesOf(texels, side);
    BrickRanges ranges;
    ranges.cells.reserve(cells.lo.size());
    const auto word = [&](T lo, T hi) {
        return rangeWord(float(lo) * scale + offset, float(hi) * scale + offset);
    };
    for (std::size_t i = 0; i < cells.lo.size(); ++i) {
        ranges.cells.push_back(word(cells.lo[i], cells.hi[i]));
    }
    ranges.all = word(*std::min_element(cells.lo.begin(), cells.lo.end()),
                      *std::max_element(cells.hi.begin(), cells.hi.end()));
    return ranges;
}

} // namespace

std::uint32_t rangeWord(float smallest, float largest) {
    return upperHalf(smallest, smallest < 0) | upperHalf(largest, largest > 0) << 16;
}

BrickRanges rangesOf(std::span<const std::byte> texels, int side, const BrickTexels& meaning) {
    switch (meaning.format) {
    case gl::Format::R8:
        return rangesOf(reinterpret_cast<const std::uint8_t*>(texels.data()), side, meaning.valueScale / 255,
                        meaning.valueOffset);
    case gl::Format::R16:
        return rangesOf(reinterpret_cast<const std::uint16_t*>(texels.data()), side,
                        meaning.valueScale / 65535, meaning.valueOffset);
    default:
        return rangesOf(reinterpret_cast<const float*>(texels.data()), side, meaning.valueScale,
                        meaning.valueOffset);
    }
}

} // namespace vs::field
