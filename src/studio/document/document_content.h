// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "studio/operations/measuring.h"
#include "studio/operations/segment_list.h"
#include "studio/operations/view.h"
#include "volume/grid/geometry.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vs::studio {

class Document;

// What a person sees of a document, as plain values: to compare one that was opened from its state with one
// that did everything again, which need not be there at the same time.
struct DocumentContent {
    View view;
    volume::GridGeometry geometry;
    sculpt::Precision precision = sculpt::Precision::Bits16;
    std::vector<std::byte> sculpture;       // all texels, x fastest
    std::vector<std::uint8_t> labels;       // of each voxel; empty: there never was a segment
    std::vector<std::uint32_t> generations; // of the segment at work
    SegmentList segments;
    std::vector<Measure> measurements;
    std::vector<std::string> parts; // names of those that were pasted
    std::size_t stepsDone = 0;      // of undo
    std::size_t stepsUndone = 0;
};

DocumentContent contentOf(const Document& document);

// What is different, a sentence each; none: the two are equal, to the byte. `first` and `second` are what
// they are called.
std::vector<std::string> differences(const DocumentContent& one, const DocumentContent& other,
                                     const std::string& first, const std::string& second);

} // namespace vs::studio
