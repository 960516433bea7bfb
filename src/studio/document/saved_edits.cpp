// SPDX-License-Identifier: Apache-2.0
#include "studio/document/saved_edits.h"

#include "base/error.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

namespace {

void fence(segment::GrowthState& state, const gl::Texture* sculpture) {
    // What is kept names some sculpture or none, and there is only one.
    state.constraints.sculpture = state.constraints.sculpture != nullptr ? sculpture : nullptr;
}

// The contents that a cut holds may lie in a file.
std::optional<sculpt::BrickDelta> cutOf(const History& history, const Edit& edit) {
    std::optional<sculpt::BrickDelta> cut = edit.cut;
    if (edit.spilled) {
        cut->giveBack(history.heldBy(edit));
    }
    return cut;
}

SavedEdit savedEdit(const History& history, const Edit& edit, bool isDone, KeptPastes& pastes) {
    SavedEdit saved;
    saved.operation = edit.operation;
    saved.cut = cutOf(history, edit);
    saved.trim = edit.trim;
    saved.changesSegments = !edit.growth.empty();
    if (isDone) {
        for (const RegionUndo& record : edit.growth) { // of finer levels no states are saved
            saved.growth.push_back(record.scene);
        }
    }
    if (edit.partsBefore) {
        saved.partsBefore = pastes.saved(*edit.partsBefore);
    }
    if (edit.partsAfter) {
        saved.partsAfter = pastes.saved(*edit.partsAfter);
    }
    saved.segmentsBefore = edit.segmentsBefore;
    saved.segmentsAfter = edit.segmentsAfter;
    saved.geometryBefore = edit.geometryBefore;
    saved.geometryAfter = edit.geometryAfter;
    saved.measurementsBefore = edit.measurementsBefore;
    saved.measurementsAfter = edit.measurementsAfter;
    saved.marksBefore = edit.marksBefore;
    saved.marksAfter = edit.marksAfter;
    saved.filledBefore = edit.filledBefore;
    saved.filledAfter = edit.filledAfter;
    saved.isLimited = edit.isLimited;
    saved.cutContent = edit.cutContent;
    return saved;
}

Edit restoredEdit(SavedEdit saved, const RestoredPastes& pastes, const gl::Texture* sculpture) {
    Edit edit{std::move(saved.operation), std::move(saved.cut), {}};
    for (const segment::GrowthUndo& record : saved.growth) {
        auto content = record.content();
        fence(content.before, sculpture);
        edit.growth.push_back({segment::GrowthUndo(std::move(content))});
    }
    if (edit.growth.empty() && saved.changesSegments) {
        edit.growth.emplace_back(); // redo makes others
    }
    if (saved.partsBefore) {
        edit.partsBefore = pastes.restored(*saved.partsBefore);
    }
    if (saved.partsAfter) {
        edit.partsAfter = pastes.restored(*saved.partsAfter);
    }
    edit.segmentsBefore = std::move(saved.segmentsBefore);
    edit.segmentsAfter = std::move(saved.segmentsAfter);
    edit.geometryBefore = saved.geometryBefore;
    edit.geometryAfter = saved.geometryAfter;
    edit.measurementsBefore = std::move(saved.measurementsBefore);
    edit.measurementsAfter = std::move(saved.measurementsAfter);
    edit.marksBefore = std::move(saved.marksBefore);
    edit.marksAfter = std::move(saved.marksAfter);
    edit.filledBefore = std::move(saved.filledBefore);
    edit.filledAfter = std::move(saved.filledAfter);
    edit.trim = std::move(saved.trim);
    edit.isLimited = saved.isLimited;
    edit.cutContent = saved.cutContent;
    return edit;
}

} // namespace

// --- pastes

int KeptPastes::numberOf(const std::shared_ptr<const gl::Texture>& paste) {
    if (!paste) {
        return -1;
    }
    const auto known = std::find(pastes_.begin(), pastes_.end(), paste);
    if (known == pastes_.end()) {
        pastes_.push_back(paste);
        return int(pastes_.size()) - 1;
    }
    return int(known - pastes_.begin());
}

SavedParts KeptPastes::saved(const PastedState& state) {
    SavedParts saved;
    saved.places = state.places;
    for (const PastedPart& part : state.parts) {
        saved.parts.push_back({static_cast<const PartInfo&>(part), numberOf(part.from), numberOf(part.upTo)});
    }
    saved.last = numberOf(state.last);
    return saved;
}

std::vector<sculpt::BrickDelta> KeptPastes::contents(sculpt::Precision precision) const {
    std::vector<sculpt::BrickDelta> all;
    for (const auto& paste : pastes_) {
        all.push_back(
            sculpt::contentOf(*paste, sculpt::bricksOf(paste->size()), sculpt::untouchedTexel(precision)));
    }
    return all;
}

RestoredPastes::RestoredPastes(const std::vector<sculpt::BrickDelta>& contents,
                               const sculpt::Sculpture& sculpture) {
    for (const sculpt::BrickDelta& content : contents) {
        gl::Texture paste(sculpture.dims(), sculpture.format(), gl::Filter::Linear, "sculpture at a paste");
        content.bringInto(paste, sculpt::untouchedTexel(sculpture.precision()));
        pastes_.push_back(std::make_shared<const gl::Texture>(std::move(paste)));
    }
}

std::shared_ptr<const gl::Texture> RestoredPastes::at(int number) const {
    if (number >= int(pastes_.size())) {
        throw Error("a pasted part names an earlier paste that is not there");
    }
    return number < 0 ? nullptr : pastes_[std::size_t(number)];
}

PastedState RestoredPastes::restored(const SavedParts& saved) const {
    PastedState state;
    state.places = saved.places;
    for (const SavedParts::Part& part : saved.parts) {
        state.parts.push_back({static_cast<const PartInfo&>(part), at(part.from), at(part.upTo)});
    }
    state.last = at(saved.last);
    return state;
}

// --- edits

std::vector<SavedEdit> savedEdits(const History& history, const std::vector<Edit>& edits,
                                  KeptPastes& pastes) {
    const bool isDone = &edits == &history.done();
    std::vector<SavedEdit> all;
    for (const Edit& edit : edits) {
        all.push_back(savedEdit(history, edit, isDone, pastes));
    }
    return all;
}

std::vector<Edit> restoredEdits(std::vector<SavedEdit> edits, const RestoredPastes& pastes,
                                const gl::Texture* sculpture) {
    std::vector<Edit> all;
    for (SavedEdit& edit : edits) {
        all.push_back(restoredEdit(std::move(edit), pastes, sculpture));
    }
    return all;
}

segment::GrowthSnapshot fencedBy(segment::GrowthSnapshot growth, const gl::Texture* sculpture) {
    fence(growth.atWork.state, sculpture);
    for (auto& [label, run] : growth.others) {
        fence(run.state, sculpture);
    }
    return growth;
}

} // namespace vs::studio
