// SPDX-License-Identifier: Apache-2.0
// Seeds, growing, playback and targeted shrink.
#include "base/error.h"
#include "studio/document/document_change.h"
#include "studio/operations/sketch.h"

#include <cstdlib>

namespace vs::studio {

namespace {

// The voxels of a set, after those there are.
void addTo(std::vector<glm::ivec3>& voxels, const segment::VoxelSet& set) {
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        if (set.inside[i] != 0) {
            voxels.push_back(set.voxelAt(i));
        }
    }
}

} // namespace

std::size_t Document::Impl::grownVoxels() const {
    return region.exists() ? std::size_t(region.growth()->voxelCount()) : 0;
}

std::string Document::Impl::millilitres(std::size_t voxels) const {
    return fmt::format("{:.1f}", double(voxels) * volume.geometry.voxelMm3() / 1000);
}

Phrase Document::Impl::describeChange(std::size_t voxelsBefore, std::size_t voxelsNow) {
    return voxelsNow > voxelsBefore ? say(VS_TEXT("library", "%1 voxels added"), voxelsNow - voxelsBefore)
                                    : say(VS_TEXT("library", "%1 voxels removed"), voxelsBefore - voxelsNow);
}

Outcome Document::Impl::describeGrowth(int generations, std::size_t voxelsBefore) const {
    const std::size_t now = grownVoxels();
    const bool isOne = std::abs(generations) == 1;
    const char* grown = isOne ? VS_TEXT("library", "%1 generation; %2 voxels, %3 ml")
                              : VS_TEXT("library", "%1 generations; %2 voxels, %3 ml");
    const char* back = isOne ? VS_TEXT("library", "%1 generation back; %2 voxels, %3 ml")
                             : VS_TEXT("library", "%1 generations back; %2 voxels, %3 ml");
    return {{},
            0,
            now > voxelsBefore ? now - voxelsBefore : voxelsBefore - now,
            say(generations < 0 ? back : grown, std::abs(generations), now, millilitres(now))};
}

void Document::Impl::workUnlocked(Region::Records& records) {
    if (segments.working().isLocked) {
        throw Error("the segment '{}' is locked; unlock it, or go to work on another",
                    segments.working().name);
    }
    region.workOn(segments.atWork, records);
}

std::vector<glm::ivec3> Document::Impl::voxelsUnder(const std::vector<Sketch>& strokes, double widthPixels,
                                                    const Canvas& canvas,
                                                    const segment::Constraints& constraints) {
    const auto pixels = pixelsUnder(strokes, widthPixels, canvas.viewport);
    return region.findSeeds(
        cutter.picker.pick(frame(canvas.view, canvas.viewport), pixels, render::Picker::Meets::Brightest),
        constraints);
}

segment::SeedCounts Document::Impl::perform(const Seed& op, Region::Records& records) {
    workUnlocked(records);
    return region.seed(
        op.voxels,
        region.constraints(*op.range, op.canvas->view.sculptureView, connectivityOf(op.connectivity)),
        records);
}

Outcome Document::Impl::run(Seed& op, const std::filesystem::path&) {
    settle(op.canvas);
    if (!op.range) {
        op.range = op.canvas->view.visibleRange(volume.range);
    }
    if (op.voxels.empty()) {
        if (!op.strokes.empty()) {
            op.voxels = voxelsUnder(op.strokes, op.widthPixels, *op.canvas,
                                    region.constraints(*op.range, op.canvas->view.sculptureView,
                                                       connectivityOf(op.connectivity)));
        }
        for (const Trail& trail : op.trails) {
            addTo(op.voxels, voxelsUnder(trail, op.range));
        }
    }
    if (op.voxels.empty()) {
        return {{}, 0, 0, say(VS_TEXT("library", "nothing seeded: no voxel in range lies under the stroke"))};
    }
    const segment::SeedCounts counts = change(op);
    return {{},
            0,
            std::size_t(counts.added),
            counts.refused > 0
                ? say(VS_TEXT("library", "%1 voxels seeded, %2 refused (outside the grid or the range, cut "
                                         "away, or another segment's)"),
                      counts.added, counts.refused)
                : say(VS_TEXT("library", "%1 voxels seeded"), counts.added)};
}

int Document::Impl::perform(const Grow& op, Region::Records& records) {
    workUnlocked(records);
    return region.grow(op.generations.value_or(Region::kEndless), *op.sculptureView, records);
}

Outcome Document::Impl::run(Grow& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    op.sculptureView = op.sculptureView.value_or(view.sculptureView);
    return describeGrowth(change(op), before);
}

int Document::Impl::perform(const Rewind& op, Region::Records& records) {
    workUnlocked(records);
    return region.rewind(op.generations, records);
}

Outcome Document::Impl::run(Rewind& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    return describeGrowth(-change(op), before);
}

void Document::Impl::perform(const ShowGeneration& op, Region::Records& records) {
    workUnlocked(records);
    region.showGeneration(op.generation, records);
}

Outcome Document::Impl::run(ShowGeneration& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    const int generation = region.exists() ? region.growth()->playhead() : 0;
    change(op);
    return describeGrowth(region.growth()->playhead() - generation, before);
}

void Document::Impl::perform(const SetGrowthRules& op, Region::Records& records) {
    workUnlocked(records);
    region.setRules(op, records);
}

Outcome Document::Impl::run(SetGrowthRules& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    change(op);
    Outcome outcome = describeGrowth(0, before);
    const Range& range = region.rules().range;
    outcome.message = say(VS_TEXT("library", "growing in %1 to %2; %3 voxels"), fmt::format("{:g}", range.lo),
                          fmt::format("{:g}", range.hi), grownVoxels());
    return outcome;
}

int Document::Impl::perform(const Absorb& op, Region::Records& records) {
    workUnlocked(records);
    return region.absorb(op.voxels, op.expansions.value_or(Region::kEndless), records);
}

Outcome Document::Impl::run(Absorb& op, const std::filesystem::path&) {
    settle(op.canvas);
    if (op.voxels.empty()) {
        segment::Constraints anything; // of what is seen: only the segment's own voxels are taken
        anything.range = volume.range;
        op.voxels = voxelsUnder(op.strokes, op.widthPixels, *op.canvas, anything);
    }
    const std::size_t before = grownVoxels();
    const int expansions = change(op);
    const std::size_t taken = before - grownVoxels();
    return {{},
            0,
            taken,
            taken == 0 ? say(VS_TEXT("library", "nothing absorbed: the stroke does not lie on the segment"))
                       : say(VS_TEXT("library", "%1 voxels absorbed in %2 expansions"), taken, expansions)};
}

void Document::Impl::perform(const ReSeed&, Region::Records& records) {
    for (const SegmentInfo& segment : segments.segments) {
        if (!segment.isLocked) {
            region.workOn(segment.label, records);
            region.clear(records);
        }
    }
    region.workOn(segments.atWork, records);
}

Outcome Document::Impl::run(ReSeed& op, const std::filesystem::path&) {
    const std::size_t before = grownVoxels();
    change(op);
    return {{}, 0, before - grownVoxels(), say(VS_TEXT("library", "segmentation cleared"))};
}

} // namespace vs::studio
