// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/part_editor.h"

#include "base/error.h"
#include "studio/editing/seen_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vs::studio {

namespace {

constexpr std::size_t kMostParts = 16;

// Part 1, Part 2 ...: the first number that no part is called by.
std::string freeName(const std::vector<PastedPart>& parts) {
    for (std::size_t number = 1;; ++number) {
        std::string name = fmt::format("Part {}", number);
        if (std::none_of(parts.begin(), parts.end(), [&](const auto& part) { return part.name == name; })) {
            return name;
        }
    }
}

Outcome saying(int part) { return {{}, 0, 0, say(VS_TEXT("library", "part %1"), part + 1)}; }

} // namespace

PastedState PartEditor::present() const {
    PastedState state = contents_.pasted;
    state.places = contents_.view.pasted;
    return state;
}

PastedPart& PartEditor::partOf(PastedState& state, int number) const {
    if (number < 0 || number >= int(state.parts.size())) {
        throw Error("there is no pasted part {}; there are {}, counted from 0", number, state.parts.size());
    }
    // A view may have been set to fewer places than there are parts.
    state.places.resize(std::max(state.places.size(), state.parts.size()));
    return state.parts[std::size_t(number)];
}

void PartEditor::show(PastedState state) noexcept {
    contents_.view.pasted = std::exchange(state.places, {}); // where they are is in the view
    contents_.pasted = std::move(state);
}

void PartEditor::change(Edit edit, PastedState state) {
    edit.partsBefore = present();
    edit.partsAfter = state;
    contents_.remember(std::move(edit));
    show(std::move(state));
}

Outcome PartEditor::run(Paste& op) {
    if (contents_.sculpture.isEmpty()) {
        throw Error("nothing to paste: cut something first");
    }
    PastedState state = present();
    // Places beyond the parts pasted so far show everything that was cut; the new part takes theirs.
    state.places.resize(state.parts.size());
    if (state.parts.size() == kMostParts) {
        throw Error("at most {} parts can be pasted; undo one, discard one, or clear all cuts", kMostParts);
    }
    PastedPart part = state.next();
    part.name = op.name.value_or(freeName(state.parts));
    part.takesTrimmed = op.takesTrimmed;
    const auto ranges = display_.cellsOfNextPart(op.takesTrimmed);
    if (std::none_of(ranges.begin(), ranges.end(), [](glm::vec2 range) { return range.y > 0.5F; })) {
        throw Error("nothing to paste: tools have cut nothing since the last paste{}",
                    op.takesTrimmed || contents_.trimmed.isEmpty()
                        ? ""
                        : "; what Keep and Clip took away is pasted with \"all\": true");
    }
    part.middleVoxel =
        middleOf(boxAround(seenCellsOfPart(contents_, display_, ranges), contents_), contents_);
    state.last = part.upTo = PastedParts::remember(contents_.sculpture);
    state.parts.push_back(std::move(part));
    state.places.push_back(op.place);
    change({shared(op), {}, {}}, state);
    return saying(int(state.parts.size()) - 1);
}

Outcome PartEditor::run(MovePart& op) {
    PastedState state = present();
    if (op.part < 0 || op.part >= int(state.places.size())) {
        throw Error("there is no pasted part {}; there are {}, counted from 0", op.part, state.places.size());
    }
    state.places[std::size_t(op.part)] = op.place;
    change({shared(op), {}, {}}, state);
    return saying(op.part);
}

Outcome PartEditor::run(ChangePart& op) {
    PastedState state = present();
    PastedPart& part = partOf(state, op.part);
    part.name = op.name.value_or(part.name);
    part.isVisible = op.isVisible.value_or(part.isVisible);
    part.takesTrimmed = op.takesTrimmed.value_or(part.takesTrimmed);
    change({shared(op), {}, {}}, state);
    return saying(op.part);
}

Outcome PartEditor::run(DiscardPart& op) {
    PastedState state = present();
    static_cast<void>(partOf(state, op.part));
    state.parts.erase(state.parts.begin() + op.part);
    state.places.erase(state.places.begin() + op.part);
    change({shared(op), {}, {}}, state);
    return saying(op.part);
}

sculpt::SculptureDelta PartEditor::clearSculpture() {
    sculpt::Sculpture& sculpture = contents_.sculpture;
    const std::uint64_t content = sculpture.contentVersion();
    sculpt::BrickBackup backup(sculpture.texels());
    for (const Box3& brick : sculpture.touchedBricks()) {
        backup.protect(brick);
    }
    sculpt::FineSculpture* finer = sculpture.finer();
    sculpt::FineDelta finest = finer != nullptr ? finer->clear() : sculpt::FineDelta();
    sculpture.clear();
    try {
        return {backup.finish(), std::move(finest)};
    } catch (...) { // no memory to hold what would undo it
        if (finer != nullptr) {
            finer->swap(finest);
        }
        sculpture.refresh(backup.restore());
        sculpture.contentIsAsAt(content);
        throw;
    }
}

Outcome PartEditor::run(UnCut& op) {
    sculpt::Sculpture& sculpture = contents_.sculpture;
    // Parts that were pasted are gone with what they were cut from; nothing is after the last paste.
    PastedState nothing;
    if (contents_.pasted.parts.empty()) {
        nothing.places = contents_.view.pasted;
    }
    Edit edit{shared(op), {}, {}};
    edit.partsBefore = present();
    edit.partsAfter = nothing;
    contents_.history.makeRoom();
    const std::uint64_t content = sculpture.contentVersion();
    sculpt::SculptureDelta delta = clearSculpture();
    const std::size_t changed = delta.changedVoxels();
    Outcome outcome{{}, 0, changed, {}};
    try {
        outcome.message = say(VS_TEXT("library", "all cuts cleared"));
        if (auto trim = contents_.trimmed.follow(sculpture, delta, false); !trim.isEmpty()) {
            edit.trim = std::move(trim);
        }
    } catch (...) {
        sculpture.swap(delta);
        sculpture.contentIsAsAt(content);
        throw;
    }
    edit.cut = std::move(delta);
    contents_.remember(std::move(edit));
    show(std::move(nothing));
    return outcome;
}

} // namespace vs::studio
