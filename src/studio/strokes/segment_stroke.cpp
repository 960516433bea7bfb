// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/segment_stroke.h"

#include "base/error.h"
#include "base/progress.h"
#include "segment/edits/fine_shapes.h"
#include "segment/edits/margins.h"
#include "segment/membership/membership.h"
#include "segment/membership/segmentation.h"
#include "segment/membership/set_membership.h"

#include <algorithm>
#include <utility>

namespace vs::studio {

namespace {

// A segment's smooth membership on the whole grid: 0.5 at its surface.
std::vector<float> smoothMembership(const field::Field& field, const segment::VoxelSet& set) {
    segment::Growth growth(field);
    growth.replace(set.box, set.inside);
    segment::Segmentation segmentation(field.geometry);
    updateWholly(segmentation, growth, segment::allOpaque());
    return segmentation.values();
}

// Voxels that may have something of a set, whose voxels `box` holds.
Box3 within(const Box3& box) { return grow(box, segment::kKernelReach); }

} // namespace

SegmentStroke::SegmentStroke(Cutter& cutter, Region& region, const field::Field& field,
                             const SegmentInfo& segment, const CutSegment& operation)
    : CutStroke(cutter, operation, false), region_(region), field_(field), label_(segment.label),
      keeps_(operation.keeps), marginMm_(operation.marginMm) {
    if (region.voxelCount(label_) == 0) {
        throw Error("the segment '{}' is empty; there is nothing to cut by", segment.name);
    }
}

void SegmentStroke::replay() { region_.isFiner() ? cutAtFinest() : cutAtScene(); }

void SegmentStroke::cutAtScene() {
    const segment::VoxelSet set = segment::changeMargin(region_.voxelsOf(label_), field_.geometry, marginMm_);
    reportProgress();
    const std::vector<float> energies = energiesOf(smoothMembership(field_, set));
    reportProgress();
    cutBy({cutter_->sculpture, field_.geometry.box(), &backup_}, energies);
    cutsInScene();
}

void SegmentStroke::cutAtFinest() {
    const volume::GridGeometry geometry = region_.geometry();
    const segment::FineSet set = segment::changeMargin(region_.finestVoxels(label_), geometry, marginMm_);
    if (keeps_) {
        fillAround(set);
    }
    // What is kept is a matter of the bricks near it; what is cut lies in some of them, too.
    const auto isNear = [&](const Box3& part) {
        const auto& bricks = set.bricks();
        return std::any_of(bricks.begin(), bricks.end(), [&](const auto& brick) {
            return !intersect(within(set.boxOf(brick.first)), part).isEmpty();
        });
    };
    const auto cutPart = [&](const sculpt::CutTarget::Part& part) {
        const std::vector<std::uint8_t> bytes = segment::membershipOf(set, part.within, geometry.spacing());
        std::vector<float> memberships(part.within.volume(), 0.0F);
        std::transform(bytes.begin(), bytes.end(), memberships.begin(),
                       [](std::uint8_t byte) { return float(byte) / 255.0F; });
        return cutBy(part, energiesOf(std::move(memberships)));
    };
    const bool isAll = keeps_ && cutter_->sculpture->isLimited();
    target().cutIn(isAll ? geometry.box() : within(set.box()), cutPart,
                   isAll ? sculpt::CutTarget::Reaches() : isNear);
    target().finish();
}

void SegmentStroke::fillAround(const segment::FineSet& set) {
    const field::BrickGrid grid{set.dims(), field::kBrick};
    std::vector<bool> isNear(Box3{glm::ivec3(0), grid.counts()}.volume(), false);
    for (const auto& [number, bits] : set.bricks()) {
        const glm::ivec3 brick = grid.brickAt(int(number));
        forEachVoxel(intersect(grow(Box3{brick, brick + 1}, 1), {glm::ivec3(0), grid.counts()}),
                     [&](glm::ivec3 place, std::size_t) { isNear[std::size_t(grid.placeOf(place))] = true; });
    }
    for (std::size_t n = 0; n < isNear.size(); ++n) {
        if (!isNear[n]) {
            target().fill(grid.boxOf(grid.brickAt(int(n))), how_);
        }
    }
}

std::vector<float> SegmentStroke::energiesOf(std::vector<float> memberships) const {
    for (float& membership : memberships) {
        membership = keeps_ ? 1 - membership : membership;
    }
    return memberships;
}

} // namespace vs::studio
