// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "sculpt/sculpture/brick_backup.h"
#include "segment/growth/growth_snapshot.h"
#include "segment/growth/growth_undo.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"
#include "studio/state/filled.h"
#include "studio/state/measured.h"
#include "studio/state/pasted_parts.h"
#include "volume/grid/geometry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace vs::studio {

// What a document holds beside its volume, in memory of the host: what a session keeps beside its log, so
// that it opens without doing everything again. A document that is made from it is as the other one was, to
// the byte, its undo and redo too.

// What a document knows about pasted parts, with the sculptures of earlier pastes by their places in
// DocumentState::pastes; -1: untouched.
struct SavedParts {
    struct Part : PartInfo {
        int from = -1;
        int upTo = -1;
    };
    std::vector<render::Placement> places;
    std::vector<Part> parts;
    int last = -1;
};

// A step of undo (studio::Edit).
struct SavedEdit {
    std::shared_ptr<const Operation> operation;
    std::optional<sculpt::BrickDelta> cut = {};
    std::optional<sculpt::BrickDelta> trim = {};
    std::vector<segment::GrowthUndo> growth = {}; // none of a step that was undone: redo makes them, if
    bool changesSegments = false;                 // it changes what segments cover
    std::optional<SavedParts> partsBefore = {};
    std::optional<SavedParts> partsAfter = {};
    std::optional<SegmentList> segmentsBefore = {};
    std::optional<SegmentList> segmentsAfter = {};
    std::optional<volume::GridGeometry> geometryBefore = {};
    std::optional<volume::GridGeometry> geometryAfter = {};
    Measurements measurementsBefore = {};
    Measurements measurementsAfter = {};
    field::SharedMarks marksBefore = {};
    field::SharedMarks marksAfter = {};
    std::optional<Filled> filledBefore = {};
    std::optional<Filled> filledAfter = {};
    bool isLimited = false;
    std::optional<std::uint64_t> cutContent = {};
};

struct DocumentState {
    std::vector<Operation> log;
    View view;
    volume::GridGeometry geometry; // where the scan's voxels lie, corrected where that was done
    sculpt::Precision precision = sculpt::Precision::Bits16;
    sculpt::BrickDelta cut; // what is cut, against nothing
    std::uint64_t sculptureVersion = 0;
    std::uint64_t sculptureContentVersion = 0;
    std::optional<sculpt::BrickDelta> trimmed = {}; // what is trimmed, against nothing
    std::vector<sculpt::BrickDelta> pastes = {};    // what was cut at earlier pastes, against nothing
    SavedParts parts;
    std::optional<segment::GrowthSnapshot> growth = {};
    SegmentList segments;
    Measurements measurements = std::make_shared<const std::vector<Measure>>();
    field::SharedMarks marks = std::make_shared<const field::Marks>();
    Filled filled;
    std::vector<SavedEdit> done;
    std::vector<SavedEdit> undone; // the next to redo last
};

} // namespace vs::studio
