// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/agreement.h"
#include "segment/statistics.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// One line of a table of segments.
struct MeasuredSegment {
    std::int64_t label = 0; // as its file has it
    std::string name;       // may be empty
    std::optional<glm::u8vec3> colour;
    segment::SegmentStatistics statistics;
};

// An aligned table for people on standard output, one line a segment. What no segment has is left out, names
// too.
void printTable(const std::vector<MeasuredSegment>& segments);

// The same and more with all digits: one line a segment, names of fields with their units in the first.
std::string csvOf(const std::vector<MeasuredSegment>& segments);

// "key value" lines on standard output.
void printAgreement(const segment::Agreement& agreement);

} // namespace vs::cli
