// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/histogram.h"
#include "studio/editing/contents.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vs::studio {

// Counts the voxels on the visible side of what was cut, in the bins of the scan's histogram: what choosing a
// displayed range can show. Counts in portions of time, anew after each cut, and looks only at those voxels
// around which something has been cut.
class VisibleHistogram {
public:
    // Goes on for about `budgetMs`. Null until all are counted. No stroke may be open.
    const std::vector<std::uint32_t>* count(const Contents& contents, double budgetMs);

private:
    void start(const Contents& contents);

    std::optional<field::VisibleHistogram> counting_;                            // made when first asked for
    std::optional<std::pair<std::uint64_t, field::SculptureView>> countingFrom_; // which contents
    bool isDone_ = false;
    std::vector<std::uint32_t> elsewhere_; // counts of the voxels that are not looked at and can be seen
    std::vector<std::uint32_t> counts_;
};

} // namespace vs::studio
