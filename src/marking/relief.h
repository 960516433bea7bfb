// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vs::marking {

// A place of the surface that a pixel shows, in world space.
struct ReliefPoint {
    glm::dvec3 world{0};
    glm::dvec3 normal{0, 0, 1}; // unit
};

// Looks for the surface under places of a picture (pixels, y down); nothing where there is none.
using PickSurface =
    std::function<std::vector<std::optional<ReliefPoint>>(const std::vector<glm::dvec2>& pixels)>;

// What the pixels of a picture show of the surface that a mark is laid on, as far as that was looked for. It
// stays as it was seen first.
class Relief {
public:
    // Looks under the pixels from lo to hi (exclusive) that are not known yet, at their centres.
    void lookUnder(glm::ivec2 lo, glm::ivec2 hi, const PickSurface& pick);
    // Null: nothing is there, or nobody has looked.
    [[nodiscard]] const ReliefPoint* at(glm::ivec2 pixel) const;
    // The point whose plane is nearest to a place in world space, among those of the four pixels whose
    // centres lie around one in the picture. Null: there is none.
    [[nodiscard]] const ReliefPoint* nearest(glm::dvec2 pixel, const glm::dvec3& world) const;

private:
    static constexpr int kChunk = 32; // pixels along a side

    struct Pixel {
        bool isKnown = false;
        bool isHit = false;
        ReliefPoint point;
    };
    using Chunk = std::vector<Pixel>;

    [[nodiscard]] static std::pair<glm::ivec2, std::size_t> placeOf(glm::ivec2 pixel);

    std::map<std::pair<int, int>, Chunk> chunks_;
    mutable const Chunk* last_ = nullptr; // the one used before, most likely again
    mutable glm::ivec2 lastPlace_{0};
};

} // namespace vs::marking
