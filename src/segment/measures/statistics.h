// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/shape.h"
#include "segment/measures/topology.h"
#include "volume/grid/volume.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vs::segment {

// How the finite values of some voxels are spread, in the volume's own unit; NaN where there is none.
struct Intensities {
    std::size_t voxels = 0; // that have a finite value
    double mean = std::numeric_limits<double>::quiet_NaN();
    double deviation = std::numeric_limits<double>::quiet_NaN(); // of these voxels, not of what they sample
    double smallest = std::numeric_limits<double>::quiet_NaN();
    double largest = std::numeric_limits<double>::quiet_NaN();
    double median =
        std::numeric_limits<double>::quiet_NaN(); // exact; of an even number the middle two's mean
};

// What one label covers.
struct SegmentStatistics {
    std::uint8_t label = 0;
    std::size_t voxels = 0;
    double millilitres = 0;
    Intensities intensities;
    Box3 box;               // voxels
    glm::dvec3 boxMm{0};    // size of the box along the index axes, from border to border
    glm::dvec3 centroid{0}; // mean of the voxels' centres, world (LPS mm)
    double surfaceMm2 = 0;  // see surface_area.h
    double sphericity = 0;  // see shape.h, as the axes
    std::array<PrincipalAxis, 3> axes;
    Topology topology;
};

// Measures every label that occurs, in the order of their numbers; 0 is none. `labels` lie on the volume's
// grid, x fastest; the volume's range must be known. Values and places take one pass over the voxels on
// several threads (values that are no whole numbers a second look for the median), surfaces and Euler numbers
// one each, parts and cavities one over each label's box.
std::vector<SegmentStatistics> measure(const volume::Volume& volume, std::span<const std::uint8_t> labels);
// Measures a volume whose voxels lie at `geometry` instead of where it says.
std::vector<SegmentStatistics> measure(const volume::Volume& volume, const volume::GridGeometry& geometry,
                                       std::span<const std::uint8_t> labels);

} // namespace vs::segment
