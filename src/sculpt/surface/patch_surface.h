// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace vs::sculpt {

// The surface that closes a hole, as a height over the plane through the surface around the hole: the quadric
// that fits that best, whatever places say that lie in furrows, and on it the thin plate that bends least to
// meet it (thin_plate.h). So it goes on with the surface's tangents, as they are over an eighth of the hole's
// width. World, mm.
class PatchSurface {
public:
    // `around`: places of the surface around the hole; `outward`: roughly out of it. `cellMm`: how finely the
    // surface is known, at least. Places that lie far off the plane belong to something else and are left
    // out. Throws Error when there are too few places, or on too few sides.
    PatchSurface(std::span<const glm::dvec3> around, const glm::dvec3& outward, double cellMm);

    // How far a place lies below the surface, along its normal (to first order), negative above it.
    [[nodiscard]] double depthOf(const glm::dvec3& place) const;
    // The plane: a place in it, and its unit normal, outward.
    [[nodiscard]] const glm::dvec3& origin() const { return origin_; }
    [[nodiscard]] const glm::dvec3& normal() const { return axes_[2]; }
    // How wide the places around are apart.
    [[nodiscard]] double widthMm() const { return widthMm_; }

private:
    void findPlane(std::span<const glm::dvec3> around, const glm::dvec3& outward);
    [[nodiscard]] glm::dvec3 inPlane(const glm::dvec3& place) const; // across, across, height; mm
    // Returns how much each place counts, at most 1.
    std::vector<double> fitQuadric(std::span<const glm::dvec3> inPlane);
    [[nodiscard]] double quadricAt(glm::dvec2 place) const;
    [[nodiscard]] double at(int x, int y) const;

    glm::dvec3 origin_{0};
    glm::dmat3 axes_{1}; // columns: two across, the normal; world
    double widthMm_ = 0;
    double cellMm_ = 1;
    glm::dvec2 first_{0}; // where the raster's first cell is
    glm::ivec2 size_{0};
    std::array<double, 6> quadric_{}; // of 1, x, y, xx, xy, yy, in halves of the width
    std::vector<double> heights_;     // on it, mm
};

} // namespace vs::sculpt
