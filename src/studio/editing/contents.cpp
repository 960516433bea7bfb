// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vs::studio {

Contents::Contents(volume::Volume volume, sculpt::Precision precision)
    : scan(std::move(volume)), sculpture(scan.volume.geometry.dims, precision),
      region(scan.field, sculpture) {
    view.range = scan.shown;
}

void Contents::show(const View& next) {
    if (!(next == view)) {
        sliceChanges += next.differsInSlicesOnly(view) ? 1 : 0;
        ++version;
        view = next;
    }
}

void Contents::remember(Edit edit) {
    history.push(std::move(edit));
    ++version;
}

void Contents::fillIn(std::optional<Canvas>& canvas) const {
    if (!canvas) {
        canvas = Canvas{view, Canvas{}.viewport};
    }
}

std::size_t Contents::grownVoxels() const {
    return region.exists() ? std::size_t(region.growth()->voxelCount()) : 0;
}

std::string Contents::millilitres(std::size_t voxels) const {
    return fmt::format("{:.1f}", double(voxels) * scan.volume.geometry.voxelMm3() / 1000);
}

std::function<bool(glm::ivec3)> Contents::lockedVoxels() const {
    std::array<bool, 256> isLocked{};
    for (const SegmentInfo& segment : segments.segments) {
        isLocked[segment.label] = segment.isLocked;
    }
    const bool any = std::find(isLocked.begin(), isLocked.end(), true) != isLocked.end();
    if (!any || !region.exists()) {
        return {};
    }
    return
        [isLocked, labels = region.growth()->labelMap(), dims = scan.volume.geometry.dims](glm::ivec3 voxel) {
            const glm::ivec3 lo = glm::max(voxel - 1, 0);
            const glm::ivec3 hi = glm::min(voxel + 1, dims - 1);
            for (int z = lo.z; z <= hi.z; ++z) {
                for (int y = lo.y; y <= hi.y; ++y) {
                    for (int x = lo.x; x <= hi.x; ++x) {
                        const auto i =
                            (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                            std::size_t(x);
                        if (isLocked[labels[i]]) {
                            return true;
                        }
                    }
                }
            }
            return false;
        };
}

} // namespace vs::studio
