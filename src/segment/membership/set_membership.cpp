// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/set_membership.h"

#include "base/parallel.h"
#include "segment/membership/fine_members.h"

#include <atomic>
#include <utility>

namespace vs::segment {

namespace {

constexpr int kPart = 64; // voxels along a side of what is worked out at once

} // namespace

bool hasAnyIn(const FineSet& set, const Box3& box) {
    const Box3 known = vs::intersect(box, {glm::ivec3(0), set.dims()});
    const field::BrickGrid grid{set.dims(), field::kBrick};
    bool hasAny = false;
    if (!known.isEmpty()) {
        forEachVoxel(Box3{known.lo / field::kBrick, divideUp(known.hi, field::kBrick)},
                     [&](glm::ivec3 brick, std::size_t) {
                         hasAny = hasAny || set.bricks().count(std::uint32_t(grid.placeOf(brick))) > 0;
                     });
    }
    return hasAny;
}

std::vector<std::uint8_t> membershipOf(const FineSet& set, const Box3& box, const glm::dvec3& spacing) {
    const MaskIn maskIn = [&set](const Box3& part) {
        return hasAnyIn(set, part) ? set.within(part) : std::vector<std::uint8_t>();
    };
    return membershipOf(maskIn, set.dims(), box, spacing);
}

std::vector<std::uint8_t> membershipOf(const MaskIn& maskIn, glm::ivec3 dims, const Box3& box,
                                       const glm::dvec3& spacing) {
    std::vector<Box3> parts;
    forEachVoxel(Box3{box.lo / kPart, divideUp(box.hi, kPart)}, [&](glm::ivec3 at, std::size_t) {
        parts.push_back(vs::intersect(box, {at * kPart, (at + 1) * kPart}));
    });
    Values<std::uint8_t> all(box);
    std::atomic<bool> isAny = false;
    inParallel(int(parts.size()), [&](int n) {
        const Box3& part = parts[std::size_t(n)];
        Members members(grow(part, kKernelReach));
        const Box3 known = vs::intersect(members.box, {glm::ivec3(0), dims});
        const std::vector<std::uint8_t> mask = known.isEmpty() ? std::vector<std::uint8_t>() : maskIn(known);
        if (mask.empty()) {
            return;
        }
        isAny = true;
        forEachVoxel(known, [&](glm::ivec3 v, std::size_t i) { members.at(v) = mask[i]; });
        const auto values = membershipOf(members, kOpaque, part, spacing, Smoothing::Smooth);
        forEachVoxel(part, [&](glm::ivec3 v, std::size_t i) { all.at(v) = values.all[i]; });
    });
    return isAny ? std::move(all.all) : std::vector<std::uint8_t>();
}

} // namespace vs::segment
