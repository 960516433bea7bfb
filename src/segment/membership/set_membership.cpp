// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/set_membership.h"

#include "base/parallel.h"
#include "segment/membership/fine_members.h"

#include <utility>

namespace vs::segment {

namespace {

constexpr int kPart = 64; // voxels along a side of what is worked out at once

bool hasAnyIn(const FineSet& set, const Box3& box) {
    const Box3 known = intersect(box, {glm::ivec3(0), set.dims()});
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

} // namespace

std::vector<std::uint8_t> membershipOf(const FineSet& set, const Box3& box, const glm::dvec3& spacing) {
    std::vector<Box3> parts;
    forEachVoxel(Box3{box.lo / kPart, divideUp(box.hi, kPart)}, [&](glm::ivec3 at, std::size_t) {
        const Box3 part = intersect(box, {at * kPart, (at + 1) * kPart});
        if (hasAnyIn(set, grow(part, kKernelReach))) {
            parts.push_back(part);
        }
    });
    if (parts.empty()) {
        return {};
    }
    Values<std::uint8_t> all(box);
    inParallel(int(parts.size()), [&](int n) {
        const Box3& part = parts[std::size_t(n)];
        Members members(grow(part, kKernelReach));
        members.all = set.within(members.box);
        const auto values = membershipOf(members, kOpaque, part, spacing, Smoothing::Smooth);
        forEachVoxel(part, [&](glm::ivec3 v, std::size_t i) { all.at(v) = values.all[i]; });
    });
    return std::move(all.all);
}

} // namespace vs::segment
