// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace vs::marking {

// Where a mark is on a surface, as a distance from its edge.

// A place of a marking pen on the surface, in world space, and half of the line's width there.
struct PathPoint {
    glm::dvec3 world{0};
    double radiusMm = 1;
    double opacity = 1;
};

// What a line comes to at a place on the surface: how far that is inside the line's edge (mm, negative
// outside), and the line's opacity there.
struct OnLine {
    double insideMm = -1e30;
    double opacity = 1;
};
// What a line comes to there that goes through these points, whose width and opacity change evenly from one
// to the next.
OnLine onLine(std::span<const PathPoint> path, const glm::dvec3& world);

// How far places of a picture lie inside closed outlines (filled by the even-odd rule), near these; in
// pixels. Lines to and fro, which join pieces of an outline and holes in it, are no edges.
class AreaDistances {
public:
    using Outline = std::vector<glm::dvec2>;

    // Distances are exact up to `reach` pixels from the nearest edge, and clamped beyond.
    AreaDistances(std::span<const Outline> outlines, double reach);

    [[nodiscard]] double insidePixels(glm::dvec2 pixel) const;
    // The pixels around the outlines from which something is less than `reach` away.
    [[nodiscard]] glm::ivec2 lo() const { return lo_; }
    [[nodiscard]] glm::ivec2 size() const { return size_; }

private:
    [[nodiscard]] double at(glm::ivec2 pixel) const;

    double reach_;
    glm::ivec2 lo_{0};
    glm::ivec2 size_{0};
    std::vector<float> distances_; // at the centres of pixels
};

} // namespace vs::marking
