// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/agreement.h"
#include "segment/measures/measured_segment.h"
#include "studio/state/measured.h"

#include <vector>

namespace vs::cli {

using segment::csvOf;
using segment::MeasuredSegment;

// An aligned table for people on standard output, one line a segment. What no segment has is left out, names
// too.
void printTable(const std::vector<MeasuredSegment>& segments);
// A table of measurements, with the digits that fit the grid; nothing where there are none.
void printTable(const std::vector<studio::Measured>& measurements, const volume::GridGeometry& geometry);

// "key value" lines on standard output.
void printAgreement(const segment::Agreement& agreement);

} // namespace vs::cli
