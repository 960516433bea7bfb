// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/field.h"
#include "phantom/phantom.h"

#include <array>
#include <random>
#include <vector>

// Inputs that several checks share. They are the same on each run.
namespace vs::studio {

inline std::size_t indexOf(glm::ivec3 v, glm::ivec3 dims) {
    return (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
           std::size_t(v.x);
}

// Whole numbers drawn evenly from lo to hi, the ends among them.
inline volume::Volume makeNoise(glm::ivec3 dims, volume::ScalarType type, int lo, int hi,
                                glm::dvec3 spacing = glm::dvec3(1)) {
    std::mt19937 random(7);
    int drawn = 0;
    return phantom::makePhantom(
        dims, type,
        [&](glm::dvec3) {
            ++drawn;
            return drawn < 3 ? double(drawn == 1 ? lo : hi)
                             : lo + double(random() % std::uint32_t(hi - lo + 1));
        },
        spacing);
}

// Moves a volume to an oblique grid with three different spacings.
inline void turnOblique(volume::Volume& volume) {
    volume.geometry.worldFromVoxel =
        glm::dmat4({0.6, 0.3, 0, 0}, {-0.4, 0.9, 0.1, 0}, {0.2, 0, 2.5, 0}, {10, -20, 30, 1});
}

// Places in the grid's box, which reaches half a voxel beyond the outermost centres.
inline std::vector<glm::vec4> placesIn(glm::ivec3 dims, int count) {
    std::mt19937 random(3);
    const auto part = [&] { return float(random() >> 8U) / float(1U << 24U); };
    std::vector<glm::vec4> places;
    for (int i = 0; i < count; ++i) {
        const float x = part();
        const float y = part();
        const float z = part();
        places.emplace_back(glm::vec3(x, y, z) * glm::vec3(dims) - 0.5F, 0);
    }
    return places;
}

} // namespace vs::studio
