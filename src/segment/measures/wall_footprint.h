// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/wall_voxels.h"

namespace vs::segment {

// What the scan sees as a voxel is no point: places around its centre that stand for as many boxes, in the
// plane across the axis (mm), and the covariance of each box with the scan's blur (mm^2).
struct Footprint {
    static constexpr std::size_t kMostPlaces = 8;
    std::array<glm::dvec2, kMostPlaces> places{};
    std::size_t count = 0;
    glm::dmat2 covariance{0};
};

// How a scan sees: a voxel is the mean over its own box, blurred by a Gaussian. Slices that lie far apart may
// be as thick as that, or thinner.
struct Sight {
    double blurMm = 0;    // the Gaussian's sigma
    double thickness = 1; // of the voxels' boxes along the axis of the largest spacing, in parts of it
};

// The footprint of the voxels around a station. Voxels that are longer than a step count as several, each
// about as long as a step.
Footprint footprintAt(const Lumen& lumen, const Station& station, const Sight& sight);

// How far the parts of a voxel are from the axis, of each the mean and the standard deviation.
class WallParts {
public:
    WallParts() = default;
    WallParts(const Footprint& footprint, const WallVoxel& voxel);

    // How much of the voxel lies inside a wall, 0 to 1, and how that changes with the wall's radius.
    struct Inside {
        double part = 0, change = 0;
    };
    [[nodiscard]] Inside inside(double wallMm) const;

private:
    std::array<double, Footprint::kMostPlaces> means_{}, spreads_{};
    std::size_t count_ = 0;
};

} // namespace vs::segment
