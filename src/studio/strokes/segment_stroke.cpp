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
    const std::vector<bool> isLeft = keeps_ ? fillAround(set) : std::vector<bool>();
    const field::BrickGrid grid{set.dims(), field::kBrick};
    // The set is nowhere near, or a brick must be cut voxel by voxel.
    const auto reaches = [&](const Box3& part) {
        bool isAny = segment::hasAnyIn(set, within(part));
        forEachVoxel(Box3{part.lo / field::kBrick, divideUp(part.hi, field::kBrick)},
                     [&](glm::ivec3 brick, std::size_t) {
                         isAny = isAny || (!isLeft.empty() && isLeft[std::size_t(grid.placeOf(brick))]);
                     });
        return isAny;
    };
    const auto cutPart = [&](const sculpt::CutTarget::Part& part) {
        const std::vector<std::uint8_t> bytes = segment::membershipOf(set, part.within, geometry.spacing());
        std::vector<float> memberships(part.within.volume(), 0.0F);
        std::transform(bytes.begin(), bytes.end(), memberships.begin(),
                       [](std::uint8_t byte) { return float(byte) / 255.0F; });
        return cutBy(part, energiesOf(std::move(memberships)));
    };
    target().cutIn(keeps_ ? geometry.box() : within(set.box()), cutPart, reaches);
    target().finish();
}

std::vector<bool> SegmentStroke::fillAround(const segment::FineSet& set) {
    const field::BrickGrid grid{set.dims(), field::kBrick};
    const glm::ivec3 counts = grid.counts();
    std::vector<bool> isLeft(grid.count(), false);
    forEachVoxel(Box3{glm::ivec3(0), counts}, [&](glm::ivec3 brick, std::size_t n) {
        if (brick.x == 0 && brick.y == 0) {
            reportProgress(double(brick.z) / counts.z);
        }
        const Box3 box = grid.boxOf(brick);
        isLeft[n] = !segment::hasAnyIn(set, within(box)) && !target().fill(box, how_);
    });
    return isLeft;
}

std::vector<float> SegmentStroke::energiesOf(std::vector<float> memberships) const {
    for (float& membership : memberships) {
        membership = keeps_ ? 1 - membership : membership;
    }
    return memberships;
}

} // namespace vs::studio
