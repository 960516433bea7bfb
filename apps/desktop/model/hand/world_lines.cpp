// SPDX-License-Identifier: Apache-2.0
#include "model/hand/world_lines.h"

#include "model/document/view_model.h"

#include <cmath>

namespace vs::desktop {

std::array<glm::dvec3, 8> boxCorners(glm::dvec3 lo, glm::dvec3 hi, const glm::dmat4& worldFromBox) {
    std::array<glm::dvec3, 8> corners;
    for (int n = 0; n < 8; ++n) {
        const glm::dvec3 corner((n & 1) != 0 ? hi.x : lo.x, (n & 2) != 0 ? hi.y : lo.y,
                                (n & 4) != 0 ? hi.z : lo.z);
        corners[std::size_t(n)] = glm::dvec3(worldFromBox * glm::dvec4(corner, 1.0));
    }
    return corners;
}

QPainterPath boxEdges(glm::dvec3 lo, glm::dvec3 hi, const glm::dmat4& worldFromBox, const ViewModel& view) {
    const auto corners = boxCorners(lo, hi, worldFromBox);
    const auto rays = view.rays();
    const auto isBehind = [&](glm::dvec3 corner) {
        const double nearestMm =
            0.01 * glm::length(hi - lo) * std::cbrt(std::abs(glm::determinant(worldFromBox)));
        return !rays.isOrthographic && glm::dot(corner - rays.eye, rays.forward) < nearestMm;
    };
    QPainterPath path;
    for (unsigned n = 0; n < 8; ++n) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            const unsigned other = n | axis;
            if (other != n && !isBehind(corners[n]) && !isBehind(corners[other])) {
                path.moveTo(view.seenAt(corners[n]));
                path.lineTo(view.seenAt(corners[other]));
            }
        }
    }
    return path;
}

} // namespace vs::desktop
