// SPDX-License-Identifier: Apache-2.0
#include "mesh/segment_surface.h"

#include "mesh/contour.h"
#include "segment/edits/label_sets.h"
#include "segment/membership/membership.h"

namespace vs::mesh {

Mesh segmentSurface(std::span<const std::uint8_t> labels, const volume::GridGeometry& geometry,
                    std::uint8_t label, const Box3& box) {
    const segment::Membership membership(labels, geometry, label);
    return contour(segment::setOf(labels, geometry.dims, label, box), geometry,
                   [&membership](glm::ivec3 inside, glm::ivec3 outside) {
                       const double in = membership.at(inside);
                       return (in - 0.5) / (in - membership.at(outside));
                   });
}

} // namespace vs::mesh
