// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document.h"
#include "studio/document/live_growth.h"
#include "studio/document/live_mark.h"
#include "studio/document/live_stroke.h"
#include "studio/document/operation_log.h"
#include "studio/document/part_queries.h"
#include "studio/document/surface_queries.h"
#include "studio/document/visible_histogram.h"
#include "studio/editing/cut_editor.h"
#include "studio/editing/file_writer.h"
#include "studio/editing/growth_editor.h"
#include "studio/editing/measurement_editor.h"
#include "studio/editing/part_editor.h"
#include "studio/editing/scan_editor.h"
#include "studio/editing/segment_list_editor.h"
#include "studio/editing/segment_shape_editor.h"
#include "studio/filling/fill_editor.h"
#include "studio/marking/mark_editor.h"

#include <memory>

namespace vs::studio {

// What a Document is made of: the contents, the editors that change them, and what all operations go through
// (log, undo, dispatch). Private to the document's own files.
struct Document::Impl {
    Impl(volume::Volume volume, sculpt::Precision precision);

    // Carries out an operation and tells the log, or throws and leaves everything as it was.
    Outcome runOrNothing(Operation operation, const std::filesystem::path& folder,
                         std::span<const Operation> coming);
    // Carries out an operation by the part that can. `folder` is where files go; `coming` is done next.
    Outcome run(Operation& operation, const std::filesystem::path& folder, std::span<const Operation> coming);
    // Goes one step back or forth in the history.
    Outcome travel(Edit& edit, bool isUndo);
    // Does an operation on segments again, for redo: growth gives the same result each time, so that redo
    // needs no memory.
    Region::Records repeat(const Operation& operation);
    [[nodiscard]] bool isIdle() const { return contents.inHand == InHand::Nothing; }

    Contents contents;
    Display display{contents};
    Cutter cutter{contents.scan.field, contents.sculpture, &contents.filled.fill};
    CutEditor cuts{contents, display, cutter};
    PartEditor parts{contents, display};
    ScanEditor scan{contents, cutter};
    MeasurementEditor measurements{contents};
    MarkEditor marks{contents, display, cutter};
    FillEditor fill{contents};
    GrowthEditor growth{contents, display, cutter};
    SegmentListEditor segmentList{contents};
    SegmentShapeEditor segmentShapes{contents, display, cutter, cuts};
    FileWriter files{contents, display, cutter};
    OperationLog log{contents.view};

    LiveStroke liveStroke{contents, cuts, log};
    LiveMark liveMark{contents, marks, log};
    LiveGrowth liveGrowth{contents, growth, log};
    SurfaceQueries surface{contents, display, cutter};
    PartQueries partQueries{contents, display};
    VisibleHistogram visibleHistogram;
    std::shared_ptr<const DocumentFacts> facts; // those that were last asked for

private:
    void takeBackSince(std::size_t stepsDone);
    void travelCut(Edit& edit, bool isUndo, Outcome& outcome);
    // Operations that belong to no editor.
    Outcome run(SetView& op);
    Outcome run(Undo&);
    Outcome run(Redo&);
    Outcome run(const Note& op);
    Outcome run(const SaveMovie& op, const std::filesystem::path& folder);
    // What the pen drew last, or draws next.
    [[nodiscard]] Drawn strokesFor(const SavePicture& op, std::span<const Operation> coming) const;
};

} // namespace vs::studio
