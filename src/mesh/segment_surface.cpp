// SPDX-License-Identifier: Apache-2.0
#include "mesh/segment_surface.h"

#include "mesh/contour.h"
#include "segment/edits/label_sets.h"
#include "segment/membership/membership.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace vs::mesh {

namespace {

constexpr int kPiece = 65; // voxels along a side, one of which the next piece has too

Crossing between(const segment::Membership& membership, glm::ivec3 first) {
    return [&membership, first](glm::ivec3 inside, glm::ivec3 outside) {
        const double in = membership.at(inside - first);
        return (in - 0.5) / (in - membership.at(outside - first));
    };
}

// The labels around a piece as far as membership in it asks for them.
struct Surroundings {
    std::vector<std::uint8_t> labels;
    std::optional<segment::Membership> membership;
};

Piece pieceOf(const Box3& box, const LabelsByBox& source, const volume::GridGeometry& geometry,
              std::uint8_t label) {
    const Box3 inGrid = intersect(box, geometry.box());
    if (inGrid.isEmpty() || source.isEmpty(inGrid)) {
        return {};
    }
    const Box3 wide = intersect(grow(inGrid, segment::kKernelReach), geometry.box());
    auto around = std::make_shared<Surroundings>();
    around->labels = source.labels(wide);
    volume::GridGeometry local = geometry;
    local.dims = wide.size();
    around->membership.emplace(around->labels, local, label);
    segment::VoxelSet set{wide, std::vector<std::uint8_t>(around->labels.size())};
    std::transform(around->labels.begin(), around->labels.end(), set.inside.begin(),
                   [&](std::uint8_t own) { return own == label ? std::uint8_t(1) : std::uint8_t(0); });
    return {set.within(box), [around, crossing = between(*around->membership, wide.lo)](
                                 glm::ivec3 in, glm::ivec3 out) { return crossing(in, out); }};
}

} // namespace

Mesh segmentSurface(const LabelsByBox& labels, const volume::GridGeometry& geometry, std::uint8_t label,
                    const Progress& progress) {
    return contour(
        geometry.box(), geometry, [&](const Box3& box) { return pieceOf(box, labels, geometry, label); },
        kPiece, progress);
}

Mesh segmentSurface(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
                    std::uint8_t label, const Box3& box) {
    const segment::Membership membership(labels, geometry, label);
    return contour(segment::setOf(labels, geometry.dims, label, box), geometry,
                   between(membership, glm::ivec3(0)));
}

} // namespace vs::mesh
