// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"

namespace vs::studio {

// Carries out the operations on materials that are no strokes (those are CutEditor's).
class FillEditor {
public:
    explicit FillEditor(Contents& contents) : contents_(contents) {}

    Outcome run(SetMaterial& op); // writes what a new one is like into the operation
    Outcome run(const RemoveFill& op);
    // For undo and redo.
    void show(const Filled& filled) { contents_.filled = filled; }

private:
    void remember(const Operation& operation, Filled after);

    Contents& contents_;
};

} // namespace vs::studio
