// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/seen_cells.h"

#include "field/cell_ranges.h"
#include "studio/editing/contents.h"
#include "studio/editing/display.h"

namespace vs::studio {

glm::dvec3 middleOfCell(std::size_t n, glm::ivec3 cellDims) {
    const int i = int(n);
    const glm::ivec3 cell(i % cellDims.x, i / cellDims.x % cellDims.y, i / cellDims.x / cellDims.y);
    return double(field::kCell) * glm::dvec3(cell) + 0.5 * (field::kCell - 1);
}

Box3 boxAround(const std::vector<glm::dvec3>& cells, const Contents& contents) {
    Box3 box;
    for (const glm::dvec3 middle : cells) {
        const glm::ivec3 cell = glm::ivec3(middle) / field::kCell;
        box = unite(box, {field::kCell * cell, field::kCell * (cell + 1)});
    }
    return intersect(box, contents.scan.volume.geometry.box());
}

glm::dvec3 middleOf(const Box3& voxels, const Contents& contents) {
    const Box3 box = voxels.isEmpty() ? contents.scan.volume.geometry.box() : voxels;
    return 0.5 * (glm::dvec3(box.lo + box.hi) - 1.0);
}

std::vector<glm::dvec3> seenCells(const Contents& contents, const Display& display,
                                  const std::function<bool(std::size_t)>& isThere) {
    const glm::ivec3 cellDims = field::cellDims(contents.scan.volume.geometry.dims);
    const auto values = display.cellRanges().cells.downloadAll<glm::vec2>();
    const Range shown = contents.view.visibleRange(contents.scan.volume.range);
    std::vector<glm::dvec3> cells;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (values[n].y >= shown.lo && values[n].x <= shown.hi && isThere(n)) {
            cells.push_back(middleOfCell(n, cellDims));
        }
    }
    return cells;
}

std::vector<glm::dvec3> seenCellsOfPart(const Contents& contents, const Display& display,
                                        const std::vector<glm::vec2>& ranges) {
    // More than half, because between two parts that touch both are half there.
    constexpr float kSurely = 0.6F;
    return seenCells(contents, display, [&](std::size_t n) { return ranges[n].y >= kSurely; });
}

} // namespace vs::studio
