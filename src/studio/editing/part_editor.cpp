// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/part_editor.h"

#include "base/error.h"

namespace vs::studio {

namespace {

constexpr std::size_t kMostParts = 16;

} // namespace

void PartEditor::show(const PastedState& state) {
    contents_.pasted = state;
    contents_.view.pasted = state.places;
}

void PartEditor::change(const Operation& operation, const PastedState& state,
                        std::optional<sculpt::BrickDelta> cut) {
    contents_.remember({shared(operation), std::move(cut), {}, present(), state});
    show(state);
}

Outcome PartEditor::run(Paste& op) {
    if (contents_.sculpture.isEmpty()) {
        throw Error("nothing to paste: cut something first");
    }
    PastedState state = present();
    // Places beyond the parts pasted so far show everything that was cut; the new part takes theirs.
    state.places.resize(std::min(state.places.size(), state.sculptures.size()));
    state.places.resize(state.sculptures.size());
    if (state.sculptures.size() == kMostParts) {
        throw Error("at most {} parts can be pasted; undo one, or clear all cuts", kMostParts);
    }
    state.sculptures.push_back(PastedParts::remember(contents_.sculpture));
    state.places.push_back(op.place);
    change(op, state);
    return {{}, 0, 0, say(VS_TEXT("library", "part %1"), contents_.pasted.sculptures.size())};
}

Outcome PartEditor::run(MovePart& op) {
    PastedState state = present();
    if (op.part < 0 || op.part >= int(state.places.size())) {
        throw Error("there is no pasted part {}; there are {}, counted from 0", op.part, state.places.size());
    }
    state.places[std::size_t(op.part)] = op.place;
    change(op, state);
    return {{}, 0, 0, say(VS_TEXT("library", "part %1"), op.part + 1)};
}

Outcome PartEditor::run(UnCut& op) {
    sculpt::Sculpture& sculpture = contents_.sculpture;
    sculpt::BrickBackup backup(sculpture.texels());
    for (const Box3& brick : sculpture.touchedBricks()) {
        backup.protect(brick);
    }
    sculpture.clear();
    sculpt::BrickDelta delta = backup.finish();
    const std::size_t changed = delta.changedVoxels();
    // Parts that were pasted are gone with what they were cut from.
    change(op, contents_.pasted.sculptures.empty() ? present() : PastedState{}, std::move(delta));
    return {{}, 0, changed, say(VS_TEXT("library", "all cuts cleared"))};
}

} // namespace vs::studio
