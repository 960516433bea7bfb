// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"

namespace vs::studio {

// Carries out the operations on pasted parts: pasting what was cut beside the rest, moving it, and clearing
// all cuts, with which they go. run() remembers the operation as a step; it throws Error before anything has
// changed.
class PartEditor {
public:
    // The contents must outlive it.
    explicit PartEditor(Contents& contents) : contents_(contents) {}

    Outcome run(Paste& op);
    Outcome run(MovePart& op);
    Outcome run(UnCut& op);

    // Which parts are pasted where, in the view too; for undo and redo.
    void show(const PastedState& state);

private:
    // The parts as they are, with places that an operation can change.
    [[nodiscard]] PastedState present() const { return {contents_.view.pasted, contents_.pasted.sculptures}; }
    void change(const Operation& operation, const PastedState& state,
                std::optional<sculpt::BrickDelta> cut = {});

    Contents& contents_;
};

} // namespace vs::studio
