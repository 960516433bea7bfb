// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/statistics.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vs::segment {

// One line of a table of segments.
struct MeasuredSegment {
    std::int64_t label = 0; // as its file has it
    std::string name;       // may be empty
    std::optional<glm::u8vec3> colour;
    SegmentStatistics statistics;
};

// Comma-separated values with all digits: one line a segment, names of fields with their units in the first.
std::string csvOf(const std::vector<MeasuredSegment>& segments);

} // namespace vs::segment
