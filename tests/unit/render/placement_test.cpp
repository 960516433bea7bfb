// SPDX-License-Identifier: Apache-2.0
#include "render/camera/placement.h"

#include "property.h"

namespace vs::render {
namespace {

rc::Gen<glm::dvec3> vectorUpTo(double most) {
    const auto one = test::between(-most, most);
    return rc::gen::construct<glm::dvec3>(one, one, one);
}

// What is at a part's middle lies 1 + spread times as far from the grid's when it is drawn, and a part can be
// put so that it is drawn anywhere.
TEST(Placement, SpreadMovesEachMiddleAwayFromTheGridsAndBack) {
    volume::GridGeometry geometry = volume::makeGeometry({40, 50, 60}, glm::dvec3(0.7, 0.8, 1.3));
    geometry.worldFromVoxel[3] = {-30, 12, 700, 1};
    test::checkProperty(400, [&] {
        Placement place;
        place.moveMm = *vectorUpTo(300);
        place.turnDegrees = *vectorUpTo(200);
        place.scale = *test::between(0.1, 3);
        const glm::dvec3 middle = *vectorUpTo(200); // voxels
        const double spread = *test::between(0, 3);
        const Placement drawn = spreadOut(place, spread, middle, geometry);
        const auto fromMiddle = [&](const Placement& p) {
            const glm::dmat4 worldFromVoxel = worldFromPart(p, geometry) * geometry.worldFromVoxel;
            return glm::dvec3(worldFromVoxel * glm::dvec4(middle, 1)) - geometry.centreWorld();
        };
        RC_ASSERT(glm::distance(fromMiddle(drawn), (1 + spread) * fromMiddle(place)) < 1e-9);
        const Placement back = broughtTogether(drawn, spread, middle, geometry);
        RC_ASSERT(glm::distance(back.moveMm, place.moveMm) < 1e-9);
        RC_ASSERT(spreadOut(place, 0, middle, geometry) == place);
    });
}

} // namespace
} // namespace vs::render
