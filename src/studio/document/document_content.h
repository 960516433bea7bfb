// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "sculpt/sculpture/precision.h"
#include "segment/growth/growth.h"
#include "studio/operations/measuring.h"
#include "studio/operations/segment_list.h"
#include "studio/operations/view.h"
#include "studio/state/filled.h"
#include "volume/grid/geometry.h"

#include <cstddef>
#include <cstdint>
#include <map>
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
    std::vector<std::byte> sculpture; // all texels, x fastest
    std::vector<std::uint8_t> labels; // of each voxel; empty: there never was a segment
    std::vector<std::byte> trimmed;   // what trims left for tools, likewise; empty: there never was a trim
    std::vector<std::uint32_t> generations; // of the segment at work, hidden ones too
    // How far each segment's run is, and by which rules it goes on, by its label.
    std::map<std::uint8_t, segment::GrowthState> runs;
    SegmentList segments;
    std::vector<Measure> measurements;
    field::SharedMarks marks = std::make_shared<const field::Marks>();
    Filled filled;
    std::vector<std::string> parts; // names of those that were pasted; where they are is in the view
    std::size_t stepsDone = 0;      // of undo
    std::size_t stepsUndone = 0;
};

DocumentContent contentOf(const Document& document);

// What is different, a sentence each; none: the two are equal, to the byte. `first` and `second` are what
// they are called.
std::vector<std::string> differences(const DocumentContent& one, const DocumentContent& other,
                                     const std::string& first, const std::string& second);

} // namespace vs::studio
