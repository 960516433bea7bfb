// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_state.h"

#include "base/error.h"

namespace vs::studio {

namespace {

constexpr std::size_t kMostParts = 16;

} // namespace

// --- cutting

void Document::Impl::beginStroke(const Operation& operation) {
    strokeTimer = Timer();
    const auto onCanvas = [this](const std::optional<Canvas>& canvas) {
        return [this, canvas] { return frame(canvas->view, canvas->viewport); };
    };
    const auto make = [&](const auto& op) -> std::unique_ptr<CutStroke> {
        using Op = std::decay_t<decltype(op)>;
        if constexpr (std::is_same_v<Op, Peel>) {
            return std::make_unique<PeelStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Drill> || std::is_same_v<Op, Laser>) {
            return std::make_unique<PenStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Sweep>) {
            return std::make_unique<SweepStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Scissors>) {
            return std::make_unique<ScissorsStroke>(cutter, onCanvas(op.canvas), op);
        } else if constexpr (std::is_same_v<Op, Clip>) {
            return std::make_unique<ClipStroke>(cutter, op);
        } else if constexpr (std::is_same_v<Op, KeepConnected>) {
            return std::make_unique<KeepConnectedStroke>(cutter, onCanvas(op.canvas), region, op);
        } else {
            return nullptr;
        }
    };
    stroke = std::visit(make, operation);
    VS_CHECK(stroke != nullptr);
}

void Document::Impl::discardStroke() {
    stroke->discard();
    stroke.reset();
    ++version;
}

Outcome Document::Impl::endStroke() {
    sculpt::BrickDelta delta;
    try {
        if (const auto isLocked = lockedVoxels()) {
            stroke->spare(isLocked);
        }
        delta = stroke->finish();
    } catch (...) { // no memory to hold what would undo it
        discardStroke();
        throw;
    }
    Outcome outcome;
    outcome.voxelsTouched = delta.changedVoxels();
    outcome.message =
        !delta.isEmpty() ? say(VS_TEXT("library", "%1 voxels changed"), delta.changedVoxels())
        : stroke->onlyCuts()
            ? say(VS_TEXT("library", "nothing was cut: nothing visible lies there that was not cut already"))
            : say(VS_TEXT("library", "nothing was restored: nothing was cut away there"));
    if (!delta.isEmpty()) {
        remember(stroke->operation(), std::move(delta), {});
    }
    stroke.reset();
    return outcome;
}

template <typename Cut>
Outcome Document::Impl::cutAtOnce(Cut& op) {
    if constexpr (requires { op.canvas; }) {
        settle(op.canvas);
    }
    beginStroke(op);
    try {
        stroke->replay();
    } catch (...) {
        discardStroke();
        throw;
    }
    op = std::get<Cut>(stroke->operation());
    return endStroke();
}

Outcome Document::Impl::run(Peel& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(Drill& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(Laser& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(Sweep& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(Scissors& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(Clip& op, const std::filesystem::path&) { return cutAtOnce(op); }
Outcome Document::Impl::run(KeepConnected& op, const std::filesystem::path&) { return cutAtOnce(op); }

Outcome Document::Impl::run(UnCut& op, const std::filesystem::path&) {
    sculpt::BrickBackup backup(sculpture.texels());
    for (const Box3& brick : sculpture.touchedBricks()) {
        backup.protect(brick);
    }
    sculpture.clear();
    sculpt::BrickDelta delta = backup.finish();
    const std::size_t changed = delta.changedVoxels();
    // Parts that were pasted are gone with what they were cut from.
    arrangeParts(op, pasted.sculptures.empty() ? PastedState{view.pasted, {}} : PastedState{},
                 std::move(delta));
    return {{}, 0, changed, say(VS_TEXT("library", "all cuts cleared"))};
}

// --- pasting

void Document::Impl::showParts(const PastedState& state) {
    pasted = state;
    view.pasted = state.places;
    loggedView.pasted = state.places;
}

void Document::Impl::arrangeParts(const Operation& operation, const PastedState& state,
                                  std::optional<sculpt::BrickDelta> cut) {
    history.push({operation, std::move(cut), {}, PastedState{view.pasted, pasted.sculptures}, state});
    showParts(state);
    ++version;
}

Outcome Document::Impl::run(Paste& op, const std::filesystem::path&) {
    if (sculpture.isEmpty()) {
        throw Error("nothing to paste: cut something first");
    }
    PastedState state{view.pasted, pasted.sculptures};
    // Places beyond the parts pasted so far show everything that was cut; the new part takes theirs.
    state.places.resize(std::min(state.places.size(), state.sculptures.size()));
    state.places.resize(state.sculptures.size());
    if (state.sculptures.size() == kMostParts) {
        throw Error("at most {} parts can be pasted; undo one, or clear all cuts", kMostParts);
    }
    state.sculptures.push_back(PastedParts::remember(sculpture));
    state.places.push_back(op.place);
    arrangeParts(op, state);
    return {{}, 0, 0, say(VS_TEXT("library", "part %1"), pasted.sculptures.size())};
}

Outcome Document::Impl::run(MovePart& op, const std::filesystem::path&) {
    if (op.part < 0 || op.part >= int(view.pasted.size())) {
        throw Error("there is no pasted part {}; there are {}, counted from 0", op.part, view.pasted.size());
    }
    PastedState state{view.pasted, pasted.sculptures};
    state.places[std::size_t(op.part)] = op.place;
    arrangeParts(op, state);
    return {{}, 0, 0, say(VS_TEXT("library", "part %1"), op.part + 1)};
}

} // namespace vs::studio
