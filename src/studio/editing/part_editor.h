// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"

namespace vs::studio {

// Carries out the operations on pasted parts: pasting what was cut beside the rest, moving, naming, hiding
// and discarding it, and clearing all cuts, with which they go. run() remembers the operation as a step; it
// throws Error before anything has changed.
class PartEditor {
public:
    // Both must outlive it.
    PartEditor(Contents& contents, Display& display) : contents_(contents), display_(display) {}

    Outcome run(Paste& op);
    Outcome run(MovePart& op);
    Outcome run(ChangePart& op);
    Outcome run(DiscardPart& op);
    Outcome run(UnCut& op);

    // Which parts are pasted where, in the view too; for undo and redo.
    void show(PastedState state) noexcept;

private:
    // The parts as they are, with places that an operation can change.
    [[nodiscard]] PastedState present() const;
    // Throws Error when there is no such part.
    [[nodiscard]] PastedPart& partOf(PastedState& state, int number) const;
    void change(Edit edit, PastedState state);
    // Clears the sculpture; says what undoes that. When it throws, nothing has changed.
    sculpt::SculptureDelta clearSculpture();

    Contents& contents_;
    Display& display_;
};

} // namespace vs::studio
