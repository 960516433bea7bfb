// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/shown_places.h"

namespace vs::studio {

std::vector<render::Placement> shownPlaces(const View& view, const PastedState& pasted,
                                           const volume::GridGeometry& geometry) {
    std::vector<render::Placement> places;
    places.reserve(view.pasted.size());
    for (std::size_t k = 0; k < view.pasted.size(); ++k) {
        const glm::dvec3 middle =
            k < pasted.parts.size() ? pasted.parts[k].middleVoxel : 0.5 * (glm::dvec3(geometry.dims) - 1.0);
        places.push_back(render::spreadOut(view.pasted[k], view.spread, middle, geometry));
    }
    return places;
}

render::Placement shownPlace(const View& view, const SegmentInfo& segment,
                             const volume::GridGeometry& geometry) {
    const bool isHeld = view.held && view.held->label == segment.label;
    const render::Placement& place = isHeld ? view.held->place : segment.pulledOut->place;
    return render::spreadOut(place, view.spread, segment.pulledOut->middleVoxel, geometry);
}

} // namespace vs::studio
