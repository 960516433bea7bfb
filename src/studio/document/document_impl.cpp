// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_impl.h"

#include "base/error.h"
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
                return runByOneOf(op, cuts, parts, scan, measurements, growth, segmentList, segmentShapes);
            }
        },
        operation);
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

Outcome Document::Impl::travel(Edit& edit, bool isUndo) {
    const std::size_t before = contents.grownVoxels();
    Outcome outcome;
    if (edit.cut) {
        contents.sculpture.swap(*edit.cut);
        if (const auto known = isUndo ? contents.history.contentBeforeLast() : edit.cutContent) {
            contents.sculpture.contentIsAsAt(*known);
        }
        outcome.voxelsTouched = edit.cut->changedVoxels();
    }
    if (edit.trim) {
        contents.trimmed.swap(*edit.trim);
    }
    if (!edit.growth.empty() || edit.segmentsAfter) {
        if (isUndo) {
            contents.region.undo(edit.growth);
            contents.segments = edit.segmentsBefore.value_or(contents.segments);
        } else {
            edit.growth = repeat(*edit.operation);
        }
        outcome.voxelsTouched = describeGrowth(contents, 0, before).voxelsTouched;
    }
    if (const auto& places = isUndo ? edit.partsBefore : edit.partsAfter) {
        parts.show(*places);
    }
    if (const auto& geometry = isUndo ? edit.geometryBefore : edit.geometryAfter) {
        scan.lay(*geometry);
    }
    if (const auto& list = isUndo ? edit.measurementsBefore : edit.measurementsAfter) {
        measurements.show(list);
    }
    outcome.message = {name(*edit.operation)};
    ++contents.version;
    return outcome;
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
