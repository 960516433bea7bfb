// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/keep_connected_stroke.h"

#include "base/error.h"
#include "base/progress.h"
#include "segment/edits/beside.h"
#include "segment/growth/growth.h"
#include "volume/grid/known_ranges.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace vs::studio {

namespace {

constexpr double kPortionMs = 100; // between asking whether to go on

Error nothingUnder(const KeepConnected& op) {
    const glm::dvec2 pixel = op.pixel.value_or(glm::dvec2(0));
    return Error("keep connected: nothing in the displayed range lies under pixel {:g}, {:g}", pixel.x,
                 pixel.y);
}

Error nothingAt(const glm::ivec3& voxel) {
    return Error("keep connected: voxel {}, {}, {} is not in the displayed range, or was cut away", voxel.x,
                 voxel.y, voxel.z);
}

// All that a growth takes in from some voxels on. Empty: it takes none of those.
segment::FineSet grownFrom(const std::vector<glm::ivec3>& seeds, segment::FineGrowth& growth) {
    if (growth.addSeeds(seeds).added > 0) {
        while (growth.advanceFor(kPortionMs, Region::kEndless) > 0) {
            reportProgress();
        }
    }
    return growth.voxels(growth.label());
}

} // namespace

KeepConnectedStroke::KeepConnectedStroke(Cutter& cutter, const MakeFrame& makeFrame, Region& region,
                                         const KeepConnected& operation)
    : CutStroke(cutter, operation, false), frame_(makeFrame()), region_(&region) {
    if (frame_.scene.view == field::SculptureView::Probe) {
        throw Error("keep connected: in probe view there is nothing left to cut; go to cut view");
    }
}

void KeepConnectedStroke::replay() {
    const KeepConnected& op = std::get<KeepConnected>(operation_);
    const auto constraints = region_->constraints(
        op.canvas->view.visibleRange(frame_.scene.data->range), frame_.scene.view,
        op.connectivity == 26 ? segment::Connectivity::TwentySix : segment::Connectivity::Six);
    region_->isFiner() ? cutAtFinest(constraints) : cutAtScene(constraints);
}

field::SurfacePoints KeepConnectedStroke::underPixel() {
    const glm::vec2 pixel(std::get<KeepConnected>(operation_).pixel.value_or(glm::dvec2(0)));
    return cutter_->picker.pick(frame_, std::span(&pixel, 1), render::Picker::Meets::Brightest);
}

void KeepConnectedStroke::cutAtScene(const segment::Constraints& constraints) {
    KeepConnected& op = std::get<KeepConnected>(operation_);
    if (!op.voxel) {
        const auto voxels = region_->findSeeds(underPixel(), constraints);
        if (voxels.empty()) {
            throw nothingUnder(op);
        }
        op.voxel = voxels.front();
    }
    segment::Growth growth(*frame_.scene.data);
    growth.setConstraints(constraints);
    if (growth.addSeeds(std::span<const glm::ivec3>(&*op.voxel, 1)).added == 0) {
        throw nothingAt(*op.voxel);
    }
    growth.advance(Region::kEndless);
    growth.syncLabels();
    cutter_->islands.cut(*cutter_->sculpture, frame_.scene, growth.seedMap().labels(), backup_);
    cutsInScene();
}

std::vector<glm::ivec3> KeepConnectedStroke::seedsIn(FinestRegion& finest,
                                                     const segment::Constraints& constraints) {
    KeepConnected& op = std::get<KeepConnected>(operation_);
    if (!op.finest && op.voxel) {
        return finest.finestIn({*op.voxel});
    }
    if (!op.finest) {
        const auto voxels = finest.found(underPixel(), constraints);
        if (voxels.empty()) {
            throw nothingUnder(op);
        }
        op.finest = voxels.front();
    }
    return {*op.finest};
}

void KeepConnectedStroke::cutAtFinest(const segment::Constraints& constraints) {
    FinestRegion finest = region_->apart();
    const std::vector<glm::ivec3> seeds = seedsIn(finest, constraints);
    finest.growth().setConstraints(constraints);
    const segment::FineSet kept = grownFrom(seeds, finest.growth());
    if (kept.isEmpty()) {
        const KeepConnected& op = std::get<KeepConnected>(operation_);
        throw nothingAt(op.finest ? *op.finest : *op.voxel);
    }
    cutAllBut(kept, finest, constraints.range);
}

void KeepConnectedStroke::cutAllBut(const segment::FineSet& kept, const FinestRegion& finest,
                                    const Range& range) {
    const Box3 all{glm::ivec3(0), kept.dims()};
    const volume::KnownRanges known(finest.source(), 0);
    const auto mayBeSeen = [&](const Box3& part) {
        const auto values = known.in(grow(part, segment::kBeside));
        return !values || (values->hi >= range.lo && values->lo <= range.hi);
    };
    // As it was before: what one part loses must not hide it from the next.
    const auto cut = cutter_->sculpture->finer()->reader();
    const bool isCutAway = frame_.scene.view == field::SculptureView::Cut;
    const auto islandsIn = [&](const Box3& box) {
        const Box3 inside = intersect(box, all);
        segment::FineSet voxels(kept.dims());
        voxels.add(inside, inside, std::vector<std::uint8_t>(inside.volume(), 1));
        std::vector<std::uint8_t> islands = finest.growth().inRange(voxels, range).within(inside);
        const std::vector<std::uint8_t> isKept = kept.within(inside);
        const std::vector<float> values = isCutAway ? cut(inside) : std::vector<float>(inside.volume(), 0.0F);
        for (std::size_t i = 0; i < values.size(); ++i) {
            islands[i] = isKept[i] != 0 || values[i] >= 0.5F ? 0 : islands[i];
        }
        return segment::VoxelSet{inside, islands}.within(box).inside;
    };
    const auto cutIslands = [&](const sculpt::CutTarget::Part& part) {
        const Box3 around = grow(part.within, segment::kBeside);
        const std::vector<std::uint8_t> islands = islandsIn(around);
        const bool isAny = std::find(islands.begin(), islands.end(), 1) != islands.end();
        return isAny ? cutBy(part, segment::besideIslands(islands, kept.within(around), part.within))
                     : Box3();
    };
    target().cutIn(all, cutIslands, mayBeSeen);
}

} // namespace vs::studio
