// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/surface/tool_surface.h"

#include <optional>
#include <span>
#include <vector>

namespace vs::sculpt {

// The surface under a mask as a tool sees it: from which elements it sweeps, which way, and which of them
// belong together. Private to the sweeping of surfaces. Elements are numbered x fastest; steps lie along the
// world's axes.
class SurfaceRaster {
public:
    SurfaceRaster(std::span<const field::SurfacePoint> points, const MaskRaster& mask,
                  const volume::GridGeometry& geometry, const ToolSweep& sweep);

    // Finds which way the tool moves from each element: unit vectors, in steps along the world's axes.
    void findDirections();
    [[nodiscard]] std::vector<glm::vec3> takeDirections() { return std::move(directions_); }

protected:
    [[nodiscard]] std::size_t at(int i, int j) const {
        return std::size_t(j) * std::size_t(size_.x) + std::size_t(i);
    }
    [[nodiscard]] bool isHit(int i, int j) const {
        return i >= 0 && j >= 0 && i < size_.x && j < size_.y && isSweptFrom(at(i, j));
    }
    [[nodiscard]] glm::vec3 place(int i, int j) const { return glm::vec3(points_[at(i, j)].voxel); }
    // Offset in steps (world axes) between two places in voxel space.
    [[nodiscard]] glm::vec3 inSteps(const glm::vec3& voxels) const { return stepsFromVoxel_ * voxels; }
    [[nodiscard]] bool restores() const { return !sweep_.outwardSteps.empty(); }
    // Whether each element has a depth of its own; what is swept then has depths that are fractions of it.
    [[nodiscard]] bool hasOwnDepths() const { return restores() || !sweep_.depths.empty(); }
    [[nodiscard]] bool isSweptFrom(std::size_t n) const {
        return points_[n].voxel.w > 0.5F && (!restores() || sweep_.outwardSteps[n] > 0) &&
               (sweep_.depths.empty() || sweep_.depths[n] > 0);
    }
    [[nodiscard]] float maskAt(std::size_t n) const { return isSweptFrom(n) ? mask_.values[n] : 0.0F; }

    [[nodiscard]] bool anyHitUnderMask() const;
    // How much more energy the mask needs so that its radiation reaches kMinPeak somewhere; 1 for all but
    // thin masks.
    [[nodiscard]] float thinMaskGain() const;
    // Whether two neighbouring elements lie on one piece of surface.
    [[nodiscard]] bool isJoined(glm::ivec2 a, glm::ivec2 b) const;
    [[nodiscard]] glm::vec3 meanDirection() const;
    // The mean way from one element to the next along an axis of the raster, in steps, across the tool's
    // direction.
    [[nodiscard]] glm::vec3 meanStep(glm::ivec2 axis) const;
    // The step in voxel space from one element to the next along an axis of the raster, as a hit's neighbours
    // tell it: along the surface where they belong together, else only across the element's own path.
    [[nodiscard]] std::optional<glm::vec3> tangent(glm::ivec2 e, glm::ivec2 axis) const;

    std::span<const field::SurfacePoint> points_;
    const MaskRaster& mask_;
    const ToolSweep& sweep_;
    glm::ivec2 size_;
    glm::mat3 stepsFromVoxel_;
    glm::mat3 voxelFromSteps_;
    double spacing_ = 1; // steps between neighbouring elements
    float gap_ = 0;      // steps; neighbours farther apart are not joined
    std::vector<glm::vec3> directions_;

private:
    // Chooses the tool's directions: unit vectors, in steps along the world's axes.
    void chooseDirections();
    // Measures the median distance, in steps, between the paths of neighbouring hits.
    void measureSpacing();
    // Smooths normals over an eighth of the mask's size, so that a rough surface does not scatter its paths;
    // at least over what the radiation cannot resolve, and never so far that the shape of an organ is lost.
    void smoothDirections();
};

} // namespace vs::sculpt
