// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "sculpt/sculpture/sculpture.h"
#include "sculpt/sculpture/trimmed.h"
#include "studio/editing/in_hand.h"
#include "studio/editing/scan.h"
#include "studio/operations/segment_list.h"
#include "studio/operations/view.h"
#include "studio/state/filled.h"
#include "studio/state/history.h"
#include "studio/state/measured.h"
#include "studio/state/pasted_parts.h"
#include "studio/state/read_labels.h"
#include "studio/state/region.h"

#include <optional>
#include <string>

namespace vs::studio {

// All that a document holds and that pictures, files and undo depend on. The editors change it, each its own
// part, and keep history: what they change is one step.
struct Contents {
    Contents(volume::Volume volume, sculpt::Precision precision);
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;

    // Changes how all is looked at.
    void show(const View& next);
    // An undoable change was made.
    void remember(Edit edit);
    // Whether some of what is cut was cut by tools that spared segments or took nothing else, the stroke in
    // hand included: faces of such cuts lie on those segments' surfaces.
    [[nodiscard]] bool isCutAlongSegments() const;
    // The canvas that an operation was drawn on, where it does not say: the present view on the usual
    // viewport.
    void fillIn(std::optional<Canvas>& canvas) const;
    // Where labels that are read must lie.
    [[nodiscard]] LabelGrids labelGrids() const;
    // Voxels shown of the segment at work.
    [[nodiscard]] std::size_t grownVoxels() const;
    // So many voxels in ml, with one decimal.
    [[nodiscard]] std::string millilitres(std::size_t voxels) const;

    Scan scan;
    sculpt::Sculpture sculpture;
    sculpt::Trimmed trimmed; // what of it was trimmed away
    PastedState pasted;
    Region region;
    SegmentList segments;
    Measurements measurements = std::make_shared<const std::vector<Measure>>();
    field::SharedMarks marks = std::make_shared<const field::Marks>();
    Filled filled;
    View view;
    History history;
    std::uint64_t version = 0;      // counts changes that pictures can show
    std::uint64_t sliceChanges = 0; // how many of them slices alone show
    InHand inHand = InHand::Nothing;
    // The sculpture's version when the cut in hand began; not while it restores (Pipeline::State).
    std::optional<std::uint64_t> cuttingSince;
};

} // namespace vs::studio
