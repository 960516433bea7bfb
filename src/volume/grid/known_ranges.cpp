// SPDX-License-Identifier: Apache-2.0
#include "volume/grid/known_ranges.h"

#include "base/error.h"
#include "base/progress.h"
#include "volume/grid/visit_type.h"

#include <algorithm>

namespace vs::volume {

KnownRanges::KnownRanges(const BrickSource& source, int level) {
    try {
        extremes_ = level == 0 ? source.extremes() : std::nullopt;
    } catch (const GivenUp&) {
        throw;
    } catch (const Error&) {
    }
}

std::optional<Range> KnownRanges::in(const Box3& box) const {
    if (!extremes_) {
        return {};
    }
    const glm::ivec3 n = extremes_->cells;
    const Box3 cells =
        intersect({box.lo / extremes_->side, divideUp(box.hi, extremes_->side)}, {glm::ivec3(0), n});
    std::optional<Range> all;
    visitType(extremes_->type, [&](const auto* none) {
        const auto* ranges = reinterpret_cast<decltype(none)>(extremes_->ranges.data());
        forEachVoxel(cells, [&](glm::ivec3 cell, std::size_t) {
            const std::size_t place =
                (std::size_t(cell.z) * std::size_t(n.y) + std::size_t(cell.y)) * std::size_t(n.x) +
                std::size_t(cell.x);
            const Range range{double(ranges[2 * place]), double(ranges[2 * place + 1])};
            all = all ? Range{std::min(all->lo, range.lo), std::max(all->hi, range.hi)} : range;
        });
    });
    return all;
}

} // namespace vs::volume
