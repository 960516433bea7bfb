// SPDX-License-Identifier: Apache-2.0
#include "field/finer_cells.h"

#include "base/parallel.h"
#include "volume/grid/visit_type.h"

#include <algorithm>
#include <limits>
#include <span>

namespace vs::field {

namespace {

constexpr float kAnything = 1e30F;

// The cells of the finest level of which samples between two places along an axis of the scene may have some:
// a coarser level's voxels are means of what lies within three quarters of a voxel of the scene, and a sample
// of the finest lies between two of its own.
glm::ivec2 reached(double from, double to, int axis, const BrickGrid& finest,
                   const volume::CellExtremes& all) {
    const double scale = finest.perSceneVoxel[axis];
    const double margin = std::max(1.0, 0.75 * scale);
    const double lo = from * scale + finest.origin[axis] - margin;
    const double hi = to * scale + finest.origin[axis] + margin;
    const int last = all.cells[axis] - 1;
    return {std::clamp(int(std::floor(lo / all.side)), 0, last),
            std::clamp(int(std::floor(hi / all.side)), 0, last)};
}

// What the cells of each macrocell have together, of values of type T, two in each.
template <typename T>
void gatherRanges(const BrickGrid& finest, const volume::CellExtremes& extremes, glm::ivec3 count,
                  std::span<glm::vec2> ranges) {
    const auto* pairs = reinterpret_cast<const T*>(extremes.ranges.data());
    const auto perRow = std::size_t(extremes.cells.x);
    const auto spanOf = [&](int cell, int axis) {
        return reached(cell * kCell, (cell + 1) * kCell, axis, finest, extremes);
    };
    inParallel(count.z, [&](int z) {
        const glm::ivec2 deep = spanOf(z, 2);
        std::size_t n = std::size_t(z) * std::size_t(count.x) * std::size_t(count.y);
        for (int y = 0; y < count.y; ++y) {
            const glm::ivec2 high = spanOf(y, 1);
            for (int x = 0; x < count.x; ++x, ++n) {
                const glm::ivec2 wide = spanOf(x, 0);
                T lo = std::numeric_limits<T>::max();
                T hi = std::numeric_limits<T>::lowest();
                for (int k = deep.x; k <= deep.y; ++k) {
                    for (int j = high.x; j <= high.y; ++j) {
                        const auto row =
                            (std::size_t(k) * std::size_t(extremes.cells.y) + std::size_t(j)) * perRow;
                        for (int i = wide.x; i <= wide.y; ++i) {
                            const T* pair = pairs + 2 * (row + std::size_t(i));
                            lo = std::min(lo, pair[0]);
                            hi = std::max(hi, pair[1]);
                        }
                    }
                }
                ranges[n] = glm::clamp(glm::vec2(float(lo), float(hi)), -kAnything, kAnything);
            }
        }
    });
}

} // namespace

CellRanges finerCellRanges(glm::ivec3 sceneDims, const BrickGrid& finest,
                           const std::optional<volume::CellExtremes>& extremes, const CellRanges* ofScene) {
    const glm::ivec3 count = cellDims(sceneDims);
    const Box3 all{glm::ivec3(0), count};
    std::vector<glm::vec2> ranges(all.volume(), glm::vec2(-kAnything, kAnything));
    if (extremes) {
        volume::visitType(extremes->type,
                          [&]<typename T>(const T*) { gatherRanges<T>(finest, *extremes, count, ranges); });
    }
    if (extremes && ofScene != nullptr) {
        const auto own = ofScene->cells.downloadAll<glm::vec2>();
        for (std::size_t n = 0; n < ranges.size(); ++n) {
            ranges[n] = {std::min(ranges[n].x, own[n].x), std::max(ranges[n].y, own[n].y)};
        }
    }
    gl::Texture cells(count, gl::Format::RG32F, gl::Filter::Nearest, "cell ranges of finer levels");
    cells.upload(all, std::as_bytes(std::span(ranges)));
    return {std::move(cells)};
}

} // namespace vs::field
