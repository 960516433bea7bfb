// SPDX-License-Identifier: Apache-2.0
#include "growing_scanline.h"

#include "base/timer.h"

#include <algorithm>
#include <vector>

namespace vs {

namespace {

// Fills from runs of voxels along x.
template <typename T>
class ScanlineFill {
public:
    ScanlineFill(const T* values, glm::ivec3 dims, T lo, T hi)
        : values_(values), dims_(dims), lo_(lo), hi_(hi),
          labels_(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z)) {}

    std::uint64_t fill(glm::ivec3 seed) {
        std::uint64_t filled = 0;
        std::vector<glm::ivec3> seeds{seed};
        while (!seeds.empty()) {
            const glm::ivec3 at = seeds.back();
            seeds.pop_back();
            const std::size_t row = rowOf(at.y, at.z);
            if (!isOpen(row + std::size_t(at.x))) {
                continue;
            }
            int first = at.x;
            int last = at.x;
            for (; first > 0 && isOpen(row + std::size_t(first - 1)); --first) {
            }
            for (; last + 1 < dims_.x && isOpen(row + std::size_t(last + 1)); ++last) {
            }
            std::fill(labels_.begin() + std::ptrdiff_t(row) + first,
                      labels_.begin() + std::ptrdiff_t(row) + last + 1, std::uint8_t(1));
            filled += std::uint64_t(last - first + 1);
            seedBeside(first, last, at.y - 1, at.z, seeds);
            seedBeside(first, last, at.y + 1, at.z, seeds);
            seedBeside(first, last, at.y, at.z - 1, seeds);
            seedBeside(first, last, at.y, at.z + 1, seeds);
        }
        return filled;
    }

private:
    [[nodiscard]] std::size_t rowOf(int y, int z) const {
        return (std::size_t(z) * std::size_t(dims_.y) + std::size_t(y)) * std::size_t(dims_.x);
    }
    [[nodiscard]] bool isOpen(std::size_t i) const {
        return labels_[i] == 0 && values_[i] >= lo_ && values_[i] <= hi_;
    }
    // One seed for each open run beside a filled one.
    void seedBeside(int first, int last, int y, int z, std::vector<glm::ivec3>& seeds) const {
        if (y < 0 || z < 0 || y >= dims_.y || z >= dims_.z) {
            return;
        }
        const std::size_t row = rowOf(y, z);
        bool wasOpen = false;
        for (int x = first; x <= last; ++x) {
            const bool isOpenHere = isOpen(row + std::size_t(x));
            if (isOpenHere && !wasOpen) {
                seeds.emplace_back(x, y, z);
            }
            wasOpen = isOpenHere;
        }
    }

    const T* values_;
    glm::ivec3 dims_;
    T lo_;
    T hi_;
    std::vector<std::uint8_t> labels_;
};

} // namespace

PeerRun growByScanlines(const GrowingCase& task) {
    return volume::visit(task.volume, [&]<typename T>(const T* values) {
        const Timer timer;
        ScanlineFill<T> fill(values, task.volume.geometry.dims, T(task.range.lo), T(task.range.hi));
        std::uint64_t voxels = 0;
        for (const glm::ivec3 seed : task.seeds) {
            voxels += fill.fill(seed);
        }
        return PeerRun{timer.milliseconds(), voxels};
    });
}

} // namespace vs
