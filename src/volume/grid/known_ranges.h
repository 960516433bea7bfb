// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "volume/grid/brick_source.h"

#include <optional>

namespace vs::volume {

// What boxes of a level may hold, as far as its source knows without reading them.
class KnownRanges {
public:
    // Where they cannot be read nothing is known.
    KnownRanges(const BrickSource& source, int level);

    // The smallest and the largest value that there may be; nothing: anything.
    [[nodiscard]] std::optional<Range> in(const Box3& box) const;

private:
    std::optional<CellExtremes> extremes_; // of the finest level alone
};

} // namespace vs::volume
