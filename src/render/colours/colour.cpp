// SPDX-License-Identifier: Apache-2.0
#include "render/colours/colour.h"

#include <cmath>

namespace vs::render {

namespace {

double linearChannel(double display) {
    const double c = std::abs(display);
    return std::copysign(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4), display);
}

double displayChannel(double linear) {
    const double c = std::abs(linear);
    return std::copysign(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055, linear);
}

} // namespace

glm::dvec3 linearFromDisplay(glm::dvec3 c) {
    return {linearChannel(c.x), linearChannel(c.y), linearChannel(c.z)};
}

glm::dvec3 displayFromLinear(glm::dvec3 c) {
    return {displayChannel(c.x), displayChannel(c.y), displayChannel(c.z)};
}

glm::dvec3 linearFromColour(Colour colour) { return linearFromDisplay(glm::dvec3(colour) / 255.0); }

Colour colourFromLinear(glm::dvec3 linear) {
    return Colour(glm::round(255.0 * glm::clamp(displayFromLinear(linear), 0.0, 1.0)));
}

glm::dvec3 oklabFromLinear(glm::dvec3 c) {
    const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
    const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
    const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

glm::dvec3 linearFromOklab(glm::dvec3 lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
    const double m = cube(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
    const double s = cube(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

} // namespace vs::render
