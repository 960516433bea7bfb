// SPDX-License-Identifier: Apache-2.0
#include "field/host_cell_ranges.h"

#include "base/parallel.h"
#include "field/cell_ranges.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace vs::field {

namespace {

// Smallest and largest values at each x of the rows of voxels that a row of cells covers.
template <typename T>
class Extremes {
public:
    explicit Extremes(int width) : lo_(std::size_t(width)), hi_(std::size_t(width)) {}

    void clear() {
        std::fill(lo_.begin(), lo_.end(), std::numeric_limits<T>::max());
        std::fill(hi_.begin(), hi_.end(), std::numeric_limits<T>::lowest());
    }
    void add(const T* row) {
        for (std::size_t x = 0; x < lo_.size(); ++x) {
            lo_[x] = std::min(lo_[x], row[x]);
            hi_[x] = std::max(hi_[x], row[x]);
        }
    }
    // Those of the voxels first <= x <= last.
    [[nodiscard]] glm::vec2 of(int first, int last) const {
        return {float(*std::min_element(lo_.begin() + first, lo_.begin() + last + 1)),
                float(*std::max_element(hi_.begin() + first, hi_.begin() + last + 1))};
    }

private:
    std::vector<T> lo_;
    std::vector<T> hi_;
};

// The cells of one slice of cells.
template <typename T>
void rangesOfSlice(const T* values, glm::ivec3 dims, int cellZ, glm::vec2* out) {
    const glm::ivec3 cells = cellDims(dims);
    const auto lastOf = [&](int cell, int axis) { return std::min(kCell * (cell + 1), dims[axis] - 1); };
    Extremes<T> extremes(dims.x);
    for (int cellY = 0; cellY < cells.y; ++cellY) {
        extremes.clear();
        for (int z = kCell * cellZ; z <= lastOf(cellZ, 2); ++z) {
            for (int y = kCell * cellY; y <= lastOf(cellY, 1); ++y) {
                extremes.add(values +
                             (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x));
            }
        }
        for (int cellX = 0; cellX < cells.x; ++cellX) {
            *out++ = extremes.of(kCell * cellX, lastOf(cellX, 0));
        }
    }
}

} // namespace

std::vector<glm::vec2> hostCellRanges(const volume::Volume& volume) {
    return volume::visit(volume, [&]<typename T>(const T* values) {
        std::vector<glm::vec2> ranges;
        if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
            const glm::ivec3 dims = volume.geometry.dims;
            const glm::ivec3 cells = cellDims(dims);
            const std::size_t perSlice = std::size_t(cells.x) * std::size_t(cells.y);
            ranges.resize(perSlice * std::size_t(cells.z));
            inParallel(cells.z, [&](int z) {
                rangesOfSlice(values, dims, z, ranges.data() + perSlice * std::size_t(z));
            });
        }
        return ranges;
    });
}

} // namespace vs::field
