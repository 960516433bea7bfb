// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document_state.h"

#include "base/check.h"
#include "base/progress.h"
#include "render/marks/draw_annotations.h"
#include "studio/operations/sketch.h"
#include "volume/io/write.h"

#include <cstdlib>

namespace vs::studio {

// --- looking

Outcome Document::Impl::run(SetView& op, const std::filesystem::path&) {
    view.camera = op.camera.value_or(view.camera);
    view.mode = op.mode.value_or(view.mode);
    view.range = op.range.value_or(view.range);
    view.sculptureView = op.sculptureView.value_or(view.sculptureView);
    view.transferFunction = op.transferFunction.value_or(view.transferFunction);
    view.pasted = op.pasted.value_or(view.pasted);
    view.sampling = op.sampling.value_or(view.sampling);
    view.shadows = op.shadows.value_or(view.shadows);
    view.hidesAbove = op.hidesAbove.value_or(view.hidesAbove);
    view.surfaceSmoothing = op.surfaceSmoothing.value_or(view.surfaceSmoothing);
    view.tintsSegments = op.tintsSegments.value_or(view.tintsSegments);
    // Logged whole: what was looked at before is part of it.
    op = lookAs(view);
    loggedView = view;
    ++version;
    return {};
}

// --- undo and redo

Outcome Document::Impl::run(Undo&, const std::filesystem::path&) {
    if (!history.canUndo()) {
        throw Error("nothing to undo");
    }
    Outcome outcome = travel(history.toUndo(), true);
    history.tookBack();
    return outcome;
}

Outcome Document::Impl::run(Redo&, const std::filesystem::path&) {
    if (!history.canRedo()) {
        throw Error("nothing to redo");
    }
    Outcome outcome = travel(history.toRedo(), false);
    history.appliedAgain();
    return outcome;
}

Outcome Document::Impl::travel(Step& step, bool isUndo) {
    const std::size_t before = grownVoxels();
    Outcome outcome;
    if (step.cut) {
        sculpture.swap(*step.cut);
        outcome.voxelsTouched = step.cut->changedVoxels();
    }
    if (!step.growth.empty() || step.segmentsAfter) {
        if (isUndo) {
            region.undo(step.growth);
            segments = step.segmentsBefore.value_or(segments);
        } else {
            step.growth = repeat(step.operation);
        }
        outcome.voxelsTouched = describeGrowth(0, before).voxelsTouched;
    }
    if (const auto& parts = isUndo ? step.partsBefore : step.partsAfter) {
        showParts(*parts);
    }
    outcome.message = {name(step.operation)};
    ++version;
    return outcome;
}

Outcome Document::replaceLast(const Operation& operation) {
    VS_CHECK(!isStrokeOpen() && !isGrowing() && !isScrubbing());
    const auto isOfTheKind = [&](const Operation& other) { return other.index() == operation.index(); };
    if (!canUndo() || canRedo() || impl_->log.size() <= impl_->sealed || !isOfTheKind(impl_->log.back()) ||
        !isOfTheKind(*lastStep()) || !(impl_->view == impl_->loggedView)) {
        return apply(operation);
    }
    impl_->travel(impl_->history.toUndo(), true);
    impl_->history.forgetLast();
    const Operation replaced = std::move(impl_->log.back());
    impl_->log.pop_back();
    try {
        return apply(operation);
    } catch (...) {
        const ProgressListener toTheEnd(
            [](auto) { return true; }); // what is put back is not given up as well
        apply(replaced);
        throw;
    }
}

// Applies an operation on segments again. Growth gives the same result each time, so its redo needs no
// memory.
Region::Records Document::Impl::repeat(const Operation& operation) {
    Region::Records records;
    const SegmentList before = segments;
    try {
        std::visit(
            [&](const auto& op) {
                if constexpr (requires { perform(op, records); }) {
                    perform(op, records);
                }
            },
            operation);
    } catch (...) { // a device without room: everything is as before
        region.undo(records);
        segments = before;
        throw;
    }
    return records;
}

// --- remarks

Outcome Document::Impl::run(Note& op, const std::filesystem::path&) {
    remember(op, {}, {});
    return {{}, 0, 0, say("%1", op.text)};
}

// --- saving

Outcome Document::Impl::run(SavePicture& op, const std::filesystem::path& folder) {
    if (!caster) {
        caster.emplace();
    }
    render::Frame picture = frame(view, op.size);
    picture.samples = op.samples;
    picture.background = op.background;
    caster->render(picture);
    image::Image pixels = caster->readPicture();
    if (op.annotations) {
        render::annotate(pixels, picture.rays, volume.geometry);
    }
    image::writePng(folder / op.file, pixels);
    return {{}, 0, 0, say("%1", op.file)};
}

Outcome Document::Impl::run(SaveLabels& op, const std::filesystem::path& folder) {
    const auto labels = region.exists() ? region.growth()->labelMap()
                                        : std::vector<std::uint8_t>(volume.geometry.voxelCount(), 0);
    volume::writeGrid(folder / op.file, volume.geometry, std::span<const std::uint8_t>(labels));
    return {{}, 0, grownVoxels(), say("%1", op.file)};
}

Outcome Document::Impl::run(SaveSculpture& op, const std::filesystem::path& folder) {
    const std::vector<float> values = cutter.sculptureAsFloats();
    volume::writeGrid(folder / op.file, volume.geometry, std::span<const float>(values));
    return {{}, 0, 0, say("%1", op.file)};
}

} // namespace vs::studio
