// SPDX-License-Identifier: Apache-2.0
#include "studio/document_state.h"

#include "base/error.h"
#include "render/draw_annotations.h"
#include "studio/sketch.h"
#include "volume/write.h"

#include <cstdlib>

namespace vs::studio {

namespace {

segment::Connectivity connectivityOf(const Seed& op) {
    return op.connectivity == 26 ? segment::Connectivity::TwentySix : segment::Connectivity::Six;
}

} // namespace

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
    // Logged whole: what was looked at before is part of it.
    op = lookAs(view);
    loggedView = view;
    ++version;
    return {};
}

// --- cutting

Outcome Document::Impl::endStroke() {
    sculpt::BrickDelta delta = stroke->finish();
    Outcome outcome;
    outcome.voxelsTouched = delta.changedVoxels();
    outcome.message = delta.isEmpty() ? "nothing was cut: the sketch does not lie on a visible surface"
                                      : fmt::format("{} voxels changed", delta.changedVoxels());
    if (!delta.isEmpty()) {
        remember(stroke->operation(), std::move(delta), {});
    }
    stroke.reset();
    return outcome;
}

Outcome Document::Impl::run(Peel& op, const std::filesystem::path&) {
    settle(op.canvas);
    return cutAtOnce(op, [&] { stroke->peelTo(op.layers); });
}

Outcome Document::Impl::run(Drill& op, const std::filesystem::path&) {
    settle(op.canvas);
    return cutAtOnce(op, [&] {
        if (op.stroke.empty()) {
            stroke->stampWhereDrawn();
        }
        for (const auto& pen : op.stroke) {
            stroke->drillAt(pen);
        }
    });
}

Outcome Document::Impl::run(UnCut& op, const std::filesystem::path&) {
    sculpt::BrickBackup backup(sculpture.texels());
    for (const Box3& brick : sculpture.touchedBricks()) {
        backup.protect(brick);
    }
    sculpture.clear();
    sculpt::BrickDelta delta = backup.finish();
    const std::size_t changed = delta.changedVoxels();
    remember(op, std::move(delta), {});
    return {{}, 0, changed, "all cuts cleared"};
}

// --- growing

std::size_t Document::Impl::grownVoxels() const {
    return region.exists() ? std::size_t(region.growth()->voxelCount()) : 0;
}

Outcome Document::Impl::describeGrowth(int generations, std::size_t voxelsBefore) const {
    const std::size_t now = grownVoxels();
    return {{},
            0,
            now > voxelsBefore ? now - voxelsBefore : voxelsBefore - now,
            fmt::format("{} generation{}{}; {} voxels, {:.1f} ml", std::abs(generations),
                        std::abs(generations) == 1 ? "" : "s", generations < 0 ? " back" : "", now,
                        double(now) * volume.geometry.voxelMm3() / 1000)};
}

segment::SeedCounts Document::Impl::plant(const Seed& op, Region::Records& records) {
    return region.seed(
        op.voxels, region.constraints(*op.range, op.canvas->view.sculptureView, connectivityOf(op)), records);
}

Outcome Document::Impl::run(Seed& op, const std::filesystem::path&) {
    settle(op.canvas);
    if (!op.range) {
        op.range = op.canvas->view.range;
    }
    if (op.voxels.empty()) {
        const auto pixels = pixelsUnder(op.strokes, op.widthPixels, op.canvas->viewport);
        const auto points = picker.pick(frame(op.canvas->view, op.canvas->viewport), pixels);
        op.voxels = region.findSeeds(
            points, region.constraints(*op.range, op.canvas->view.sculptureView, connectivityOf(op)));
    }
    if (op.voxels.empty()) {
        return {{}, 0, 0, "nothing seeded: no voxel in range lies under the stroke"};
    }
    Region::Records records;
    const auto counts = plant(op, records);
    remember(op, {}, std::move(records));
    return {{},
            0,
            std::size_t(counts.added),
            counts.refused > 0
                ? fmt::format("{} voxels seeded, {} refused (outside the grid or the range, or cut away)",
                              counts.added, counts.refused)
                : fmt::format("{} voxels seeded", counts.added)};
}

Outcome Document::Impl::run(Grow& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    op.sculptureView = op.sculptureView.value_or(view.sculptureView);
    Region::Records records;
    const int generations =
        region.grow(op.generations.value_or(Region::kEndless), *op.sculptureView, records);
    remember(op, {}, std::move(records));
    return describeGrowth(generations, before);
}

Outcome Document::Impl::run(Rewind& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    Region::Records records;
    const int generations = region.rewind(op.generations, records);
    remember(op, {}, std::move(records));
    return describeGrowth(-generations, before);
}

Outcome Document::Impl::run(SetGrowthRange& op, const std::filesystem::path&) {
    Region::Records records;
    region.setRange(op.range, records);
    remember(op, {}, std::move(records));
    return {{}, 0, 0, fmt::format("growing in {:g} to {:g}", op.range.lo, op.range.hi)};
}

Outcome Document::Impl::run(ReSeed& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    Region::Records records;
    region.clear(records);
    remember(op, {}, std::move(records));
    return {{}, 0, before, "segmentation cleared"};
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
    if (!step.growth.empty()) {
        if (isUndo) {
            region.undo(step.growth);
        } else {
            step.growth = repeat(step.operation);
        }
        outcome.voxelsTouched = describeGrowth(0, before).voxelsTouched;
    }
    outcome.message = fmt::format("{}: {}", isUndo ? "undone" : "redone", name(step.operation));
    ++version;
    return outcome;
}

// Applies a region operation again. Growth gives the same result each time, so its redo needs no memory.
Region::Records Document::Impl::repeat(const Operation& operation) {
    Region::Records records;
    if (const auto* seed = std::get_if<Seed>(&operation)) {
        plant(*seed, records);
    } else if (const auto* grow = std::get_if<Grow>(&operation)) {
        region.grow(grow->generations.value_or(Region::kEndless), *grow->sculptureView, records);
    } else if (const auto* rewind = std::get_if<Rewind>(&operation)) {
        region.rewind(rewind->generations, records);
    } else if (const auto* range = std::get_if<SetGrowthRange>(&operation)) {
        region.setRange(range->range, records);
    } else {
        region.clear(records);
    }
    return records;
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
    return {{}, 0, 0, op.file};
}

Outcome Document::Impl::run(SaveLabels& op, const std::filesystem::path& folder) {
    const auto labels = region.exists() ? region.growth()->labels()
                                        : std::vector<std::uint8_t>(volume.geometry.voxelCount(), 0);
    volume::writeGrid(folder / op.file, volume.geometry, std::span<const std::uint8_t>(labels));
    return {{}, 0, grownVoxels(), op.file};
}

Outcome Document::Impl::run(SaveSculpture& op, const std::filesystem::path& folder) {
    const std::vector<float> values = cutter.sculptureAsFloats();
    volume::writeGrid(folder / op.file, volume.geometry, std::span<const float>(values));
    return {{}, 0, 0, op.file};
}

} // namespace vs::studio
