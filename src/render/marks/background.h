// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <string>

namespace vs::render {

// What is behind the volume: display (sRGB) colours, 0..1, that change smoothly from the picture's top to its
// bottom, or nothing. The studio's is a calm dark slate, lighter below, that neither bone nor vessels blend
// into.
struct Background {
    glm::vec3 top{0.055F, 0.065F, 0.08F};
    glm::vec3 bottom{0.17F, 0.19F, 0.22F};
    bool isTransparent = false; // then the colours are black

    bool operator==(const Background&) const = default;
};

// The background's colours in linear light.
glm::vec3 linearTop(const Background& background);
glm::vec3 linearBottom(const Background& background);

// The background that inverted pictures have: a light one for the studio's, any other as it is.
Background forInverted(const Background& background);
// With the complement of each colour; nothing stays nothing.
Background complement(const Background& background);

// "studio", "white", "black", "transparent", "#RRGGBB" (one colour) or "#RRGGBB:#RRGGBB" (top and bottom):
// how backgrounds stand on command lines and in sessions.
std::string name(const Background& background);
// Reads a background as it stands on command lines. Throws UsageError saying what can be written.
Background backgroundFromName(const std::string& name);

} // namespace vs::render
