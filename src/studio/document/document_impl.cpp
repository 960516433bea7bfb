// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_impl.h"

#include "base/error.h"
#include "gl/context.h"
#include "studio/editing/segment_change.h"

#include <algorithm>

namespace vs::studio {

namespace {

// Carries out an operation by the first of the editors that has a run() for it. An operation that none has
// does not compile.
template <typename Op, typename First, typename... Rest>
Outcome runByOneOf(Op& op, First& first, Rest&... rest) {
    if constexpr (requires { first.run(op); }) {
        return first.run(op);
    } else {
        return runByOneOf(op, rest...);
    }
}

// The same for doing it again.
template <typename Op, typename First, typename... Rest>
void performByOneOf(const Op& op, Region::Records& records, First& first, Rest&... rest) {
    if constexpr (requires { first.perform(op, records); }) {
        first.perform(op, records);
    } else if constexpr (sizeof...(rest) > 0) {
        performByOneOf(op, records, rest...);
    }
}

} // namespace

Document::Impl::Impl(volume::Volume volume, sculpt::Precision precision)
    : contents(std::move(volume), precision) {}

Outcome Document::Impl::run(Operation& operation, const std::filesystem::path& folder,
                            std::span<const Operation> coming) {
    return std::visit(
        [&](auto& op) {
            if constexpr (requires { files.run(op, folder, Drawn()); }) {
                return files.run(op, folder, strokesFor(op, coming));
            } else if constexpr (requires { files.run(op, folder); }) {
                return files.run(op, folder);
            } else if constexpr (requires { run(op, folder); }) {
                return run(op, folder);
            } else if constexpr (requires { run(op); }) {
                return run(op);
            } else {
                return runByOneOf(op, cuts, parts, scan, measurements, marks, fill, growth, segmentList,
                                  segmentShapes);
            }
        },
        operation);
}

Outcome Document::Impl::runOrNothing(Operation operation, const std::filesystem::path& folder,
                                     std::span<const Operation> coming) {
    contents.history.makeRoom();
    contents.history.settle();
    const std::size_t stepsDone = contents.history.done().size();
    const View seen = contents.view; // an operation may change where parts are pasted
    View before = contents.view;
    const bool wasTrimmed = !contents.trimmed.isEmpty();
    const bool hadRegion = contents.region.exists();
    try {
        Outcome outcome = run(operation, folder, coming);
        gl::Context::requireDevice();
        outcome.name = name(operation);
        log.record(std::move(operation), seen, contents.view);
        contents.history.settle();
        return outcome;
    } catch (const ContextLost&) { // there is nothing left that could be taken back
        throw;
    } catch (...) {
        takeBackSince(stepsDone);
        contents.view = std::move(before);
        if (!wasTrimmed) {
            contents.trimmed = {};
        }
        if (!hadRegion) {
            contents.region.unmake();
        }
        throw;
    }
}

// An edit may have been made, and then there was no memory to tell of it.
void Document::Impl::takeBackSince(std::size_t stepsDone) {
    History& history = contents.history;
    if (!history.isSettled()) {
        travel(history.toUndo(), true);
        history.unpush();
    } else if (history.done().size() > stepsDone) { // it was redone
        travel(history.toUndo(), true);
        history.tookBack();
    } else if (history.done().size() < stepsDone) { // it was undone
        travel(history.toRedo(), false);
        history.appliedAgain();
    }
}

Drawn Document::Impl::strokesFor(const SavePicture& op, std::span<const Operation> coming) const {
    if (op.strokes == ShownStrokes::Last) {
        const auto& done = log.operations();
        const auto last =
            std::find_if(done.rbegin(), done.rend(), [](const auto& o) { return !drawnFor(o).isEmpty(); });
        return last == done.rend() ? Drawn() : drawnFor(*last);
    }
    if (op.strokes == ShownStrokes::Next) {
        View view = contents.view;
        for (const Operation& next : coming) {
            if (const auto* look = std::get_if<SetView>(&next)) {
                view.camera = look->camera.value_or(view.camera);
            }
            if (Drawn drawn = drawnFor(next); !drawn.isEmpty()) {
                drawn.canvas = drawn.canvas.value_or(Canvas{.view = view});
                return drawn;
            }
        }
    }
    return {};
}

Outcome Document::Impl::run(SetView& op) {
    const View view = changed(contents.view, op);
    // Logged whole: what was looked at before is part of it.
    op = setViewTo(view);
    contents.show(view);
    return {};
}

Outcome Document::Impl::run(Undo&) {
    if (!contents.history.canUndo()) {
        throw Error("nothing to undo");
    }
    Outcome outcome = travel(contents.history.toUndo(), true);
    contents.history.tookBack();
    return outcome;
}

Outcome Document::Impl::run(Redo&) {
    if (!contents.history.canRedo()) {
        throw Error("nothing to redo");
    }
    Outcome outcome = travel(contents.history.toRedo(), false);
    contents.history.appliedAgain();
    return outcome;
}

Outcome Document::Impl::run(const Note& op) {
    contents.remember({shared(op), {}, {}});
    return {{}, 0, 0, say("%1", op.text)};
}

// What needs memory comes first, then what is all or nothing, and last what only puts things in their places:
// when it throws, nothing has changed.
Outcome Document::Impl::travel(Edit& edit, bool isUndo) {
    Outcome outcome;
    outcome.message = {name(*edit.operation)};
    auto segments = edit.segmentsBefore;
    auto places = isUndo ? edit.partsBefore : edit.partsAfter;
    travelCut(edit, isUndo, outcome);
    if (!edit.growth.empty() || edit.segmentsAfter) {
        const std::size_t before = contents.grownVoxels();
        if (isUndo) {
            contents.region.undo(edit.growth);
            if (segments) {
                contents.segments = std::move(*segments);
            }
        } else {
            edit.growth = repeat(*edit.operation);
        }
        const std::size_t now = contents.grownVoxels();
        outcome.voxelsTouched = now > before ? now - before : before - now;
    }
    if (places) {
        parts.show(std::move(*places));
    }
    if (const auto& geometry = isUndo ? edit.geometryBefore : edit.geometryAfter) {
        scan.lay(*geometry);
    }
    if (const auto& list = isUndo ? edit.measurementsBefore : edit.measurementsAfter) {
        measurements.show(list);
    }
    if (const auto& laid = isUndo ? edit.marksBefore : edit.marksAfter) {
        marks.show(laid);
    }
    if (const auto& filled = isUndo ? edit.filledBefore : edit.filledAfter) {
        outcome.voxelsTouched += field::changedVoxels(*contents.filled.fill, *filled->fill);
        fill.show(*filled);
    }
    ++contents.version;
    return outcome;
}

void Document::Impl::travelCut(Edit& edit, bool isUndo, Outcome& outcome) {
    if (!edit.cut) {
        return;
    }
    const std::uint64_t content = contents.sculpture.contentVersion();
    contents.sculpture.swap(*edit.cut);
    try {
        if (edit.trim) {
            contents.trimmed.swap(*edit.trim);
        }
    } catch (...) {
        contents.sculpture.swap(*edit.cut);
        contents.sculpture.contentIsAsAt(content);
        throw;
    }
    if (const auto known = isUndo ? contents.history.contentBeforeLast() : edit.cutContent) {
        contents.sculpture.contentIsAsAt(*known);
    }
    outcome.voxelsTouched = edit.cut->changedVoxels();
}

Region::Records Document::Impl::repeat(const Operation& operation) {
    Region::Records records;
    changeOrNothing(contents, records, [&] {
        std::visit([&](const auto& op) { performByOneOf(op, records, growth, segmentList, segmentShapes); },
                   operation);
    });
    return records;
}

} // namespace vs::studio
