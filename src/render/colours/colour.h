// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace vs::render {

// A colour as people choose it: display sRGB, 8 bits a channel.
using Colour = glm::u8vec3;

// sRGB (IEC 61966-2-1), 0 to 1 each; linear light may leave 0 to 1 and is carried on oddly symmetric.
glm::dvec3 linearFromDisplay(glm::dvec3 display);
glm::dvec3 displayFromLinear(glm::dvec3 linear);
glm::dvec3 linearFromColour(Colour colour);
// The nearest that a display can show.
Colour colourFromLinear(glm::dvec3 linear);

// OKLab, where equal distances look about equally large (Ottosson 2020, "A perceptual color space for image
// processing"): x lightness 0 to 1, yz colour. From and to linear sRGB.
glm::dvec3 oklabFromLinear(glm::dvec3 linear);
glm::dvec3 linearFromOklab(glm::dvec3 oklab);

} // namespace vs::render
