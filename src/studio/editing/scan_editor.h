// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"
#include "studio/operations/operation.h"
#include "studio/strokes/cutter.h"

namespace vs::studio {

// Corrects where the scan's voxels lie.
class ScanEditor {
public:
    // Both must outlive it.
    ScanEditor(Contents& contents, Cutter& cutter) : contents_(contents), cutter_(cutter) {}

    Outcome run(CorrectGeometry& op);
    // For undo and redo.
    void lay(const volume::GridGeometry& geometry);

private:
    Contents& contents_;
    Cutter& cutter_;
};

} // namespace vs::studio
