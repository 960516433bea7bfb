// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"
#include "studio/marking/mark_stroke.h"

#include <memory>

namespace vs::studio {

// Lays marks and takes them away, all at once or as a stroke that is seen while it goes on.
class MarkEditor {
public:
    // All three must outlive it.
    MarkEditor(Contents& contents, Display& display, Cutter& cutter)
        : contents_(contents), display_(display), cutter_(cutter) {}

    Outcome run(Mark& op);
    Outcome run(const RemoveMarks& op);
    // For undo and redo.
    void show(field::SharedMarks marks) { contents_.marks = std::move(marks); }

    // Opens the stroke of a mark whose canvas is set; then there is a stroke(), until finish() makes a step
    // of it or discard() leaves no trace.
    void begin(const Mark& op);
    [[nodiscard]] bool isOpen() const { return stroke_ != nullptr; }
    [[nodiscard]] const MarkStroke& stroke() const { return *stroke_; }
    void drawAt(const sculpt::PenPoint& pen);
    Outcome finish();
    void discard();

private:
    void remember(const Operation& operation, const field::SharedMarks& before,
                  const field::SharedMarks& after);

    Contents& contents_;
    Display& display_;
    Cutter& cutter_;
    std::unique_ptr<MarkStroke> stroke_; // the one that is open
};

} // namespace vs::studio
