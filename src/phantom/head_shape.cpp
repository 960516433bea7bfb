// SPDX-License-Identifier: Apache-2.0
#include "phantom/head_shape.h"

#include "phantom/solid_distances.h"

#include <cmath>

namespace vs::phantom {

namespace {

double skullThickness(glm::dvec3 p) {
    return 6.2 + 1.3 * std::sin(0.055 * p.y + 0.8) + 0.8 * std::sin(0.083 * p.x + 1) * std::sin(0.071 * p.z) +
           0.4 * std::sin(0.21 * p.y + 0.17 * p.z);
}

// The temporal muscles make the scalp thicker at the sides.
double headSurface(glm::dvec3 p, double outerSkull) {
    const glm::dvec3 m = mirrored(p);
    const double temples = 7 * std::exp(-std::pow((p.y + 28) / 30, 2) - std::pow((p.z + 12) / 26, 2)) *
                           glm::smoothstep(25.0, 60.0, m.x);
    const double scalp = outerSkull - 5.4 - 0.8 * std::sin(0.06 * p.y + 0.05 * p.z) - temples;
    const double face = ellipsoidDistance(p - glm::dvec3(0, -38, -54), {59, 60, 66});
    const double neck = coneDistance(p, {0, 32, -48}, 56, {0, 27, -130}, 54);
    const double nose = coneDistance(p, {0, -88, -26}, 6, {0, -98, -56}, 8);
    const double chin = coneDistance(m, {6, -76, -94}, 18, {0, -78, -90}, 18);
    const double ear = ellipsoidDistance(m - glm::dvec3(76 + 0.3 * (p.y - 12), 14, -30), {5, 14, 24});
    const double sockets = ellipsoidDistance(m - glm::dvec3(31, -99, -33), {17, 9, 8});
    const double solid =
        smoothMin(smoothMin(smoothMin(smoothMin(scalp, neck, 25), face, 18), chin, 15), nose, 8);
    return smoothMin(smoothMax(solid, -sockets, 10), ear, 6);
}

} // namespace

// A vault, a posterior fossa, and a floor that is high over the eyes.
double skullInside(glm::dvec3 p) {
    const double vault = ellipsoidDistance(p - glm::dvec3(0, 4, 8), {69, 86, 62.5});
    const double fossa = ellipsoidDistance(p - glm::dvec3(0, 44, -34), {56, 43, 32});
    const double fromLobe = (std::abs(p.x) - 36) / 30; // the middle fossae reach forward at the sides
    const double floor =
        glm::mix(-13.0, -62.0, glm::smoothstep(-50.0, -14.0, p.y - 16 * fromLobe * fromLobe));
    const double clivus = coneDistance(p, {0, -20, -36}, 12, {0, 8, -64}, 9);
    return smoothMax(smoothMax(smoothMin(vault, fossa, 14), 0.7 * (floor - p.z), 8), -clivus, 8);
}

HeadShape headShape(glm::dvec3 p) {
    HeadShape shape;
    shape.skullPlace = {p.x * (1 - 0.0012 * p.y), p.y, p.z};
    shape.inner = skullInside(shape.skullPlace);
    shape.outer = shape.inner - skullThickness(p);
    // Within the vault no one asks how far the skin is.
    shape.skin = shape.inner < -20 ? shape.outer : headSurface(p, shape.outer);
    return shape;
}

} // namespace vs::phantom
