// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/lumen.h"
#include "volume/grid/volume.h"

#include <vector>

namespace vs::segment {

// The values of a scan, asked by voxel or by place. What is outside the grid or not finite is NaN.
class ScanValues {
public:
    // Both must outlive it. The volume and the lumen have the same grid.
    ScanValues(const volume::Volume& volume, const Lumen& lumen) : volume_(volume), lumen_(lumen) {}

    [[nodiscard]] double at(glm::ivec3 voxel) const;
    // Between the eight voxels around a place in the world (mm).
    [[nodiscard]] double between(const glm::dvec3& place) const;

private:
    const volume::Volume& volume_;
    const Lumen& lumen_;
};

// The values on both sides of a vessel's wall around one station: well inside, and for each ray a little
// outside. Outside is NaN where the two are hard to tell apart, for there is no edge then.
struct Plateaus {
    double inside = 0;
    double noise = 0; // standard deviation of single values inside
    std::array<double, kRays> outside{};
};

// The plateaus at the stations of a curve: medians of values nearby, in which single bright or dark places
// have no say. `outlines` are what is seen of the wall from the stations, in its middle.
std::vector<Plateaus> plateausAlong(const ScanValues& values, const Lumen& lumen, const Curve& curve,
                                    const std::vector<Outline>& outlines);

} // namespace vs::segment
