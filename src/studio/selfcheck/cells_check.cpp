// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"

#include "field/cell_ranges.h"

#include <algorithm>

namespace vs::studio {

void checkCellRanges(Tally& tally) {
    constexpr glm::ivec3 dims(23, 9, 14); // no multiple of a cell
    for (const auto type : volume::kScalarTypes) {
        const auto volume = makeNoise(dims, type, 0, volume::sizeOf(type) == 1 ? 127 : 30000);
        const auto ranges = field::computeCellRanges(field::uploadVolume(volume));
        const auto found = ranges.cells.downloadAll<glm::vec2>();
        const glm::ivec3 cells = field::cellDims(dims);
        tally.about(std::string("ends of ranges, ") + name(type));
        tally.require(ranges.cells.size() == cells);
        forEachVoxel({glm::ivec3(0), ranges.cells.size()}, [&](glm::ivec3 cell, std::size_t n) {
            Range expected{1e30, -1e30};
            const glm::ivec3 first = cell * field::kCell;
            forEachVoxel({first, glm::min(first + field::kCell + 1, dims)}, [&](glm::ivec3 v, std::size_t) {
                expected = {std::min(expected.lo, volume.at(v)), std::max(expected.hi, volume.at(v))};
            });
            tally.compare(double(found[n].x), expected.lo, 0.01);
            tally.compare(double(found[n].y), expected.hi, 0.01);
        });
    }
}

} // namespace vs::studio
