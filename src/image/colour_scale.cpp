// SPDX-License-Identifier: Apache-2.0
#include "image/colour_scale.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vs::image {

namespace {

// Oklab from its nonlinear cone responses, and those from linear sRGB: columns as in Ottosson's tables.
const glm::dmat3 kLabFromCones{0.2104542553, 1.9779984951,  0.0259040371, 0.7936177850, -2.4285922050,
                               0.7827717662, -0.0040720468, 0.4505937099, -0.8086757660};
const glm::dmat3 kConesFromLinear{0.4122214708, 0.2119034982, 0.0883024619, 0.5363325363, 0.6806995451,
                                  0.2817188376, 0.0514459929, 0.1073969566, 0.6299787005};

double displayFromLinear(double c) {
    c = std::clamp(c, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

double linearFromDisplay(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

// The curve: lightness evenly upward, hue from violet through red to yellow, strongest in the middle.
glm::dvec3 labAt(double t) {
    const double lightness = 0.14 + 0.83 * t;
    const double hue = (285 + 180 * t) * std::numbers::pi / 180;
    const double chroma = 0.03 + 0.145 * std::sin(std::numbers::pi * std::pow(t, 0.85));
    return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

Colour displayFromLab(glm::dvec3 lab) {
    const glm::dvec3 roots = glm::inverse(kLabFromCones) * lab;
    const glm::dvec3 linear = glm::inverse(kConesFromLinear) * (roots * roots * roots);
    return {displayFromLinear(linear.x), displayFromLinear(linear.y), displayFromLinear(linear.z)};
}

constexpr int kSteps = 512;
using Table = std::array<Colour, kSteps + 1>;

// The curve walked at an even pace.
Table makeTable() {
    constexpr int kFine = 8 * kSteps;
    std::array<double, kFine + 1> length{};
    for (int i = 1; i <= kFine; ++i) {
        length[std::size_t(i)] =
            length[std::size_t(i - 1)] + glm::distance(labAt((i - 1.0) / kFine), labAt(double(i) / kFine));
    }
    Table table;
    int at = 0;
    for (int i = 0; i <= kSteps; ++i) {
        while (at < kFine && length[std::size_t(at)] < length[kFine] * i / kSteps) {
            ++at;
        }
        table[std::size_t(i)] = displayFromLab(labAt(double(at) / kFine));
    }
    return table;
}

} // namespace

Colour densityColour(double part) {
    static const Table table = makeTable();
    return table[std::size_t(std::lround(std::clamp(part, 0.0, 1.0) * kSteps))];
}

glm::dvec3 oklab(Colour c) {
    const glm::dvec3 cones =
        kConesFromLinear *
        glm::dvec3(linearFromDisplay(c.red), linearFromDisplay(c.green), linearFromDisplay(c.blue));
    return kLabFromCones * glm::dvec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

} // namespace vs::image
