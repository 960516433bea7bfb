// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/mask/outline.h"
#include "sculpt/mask/reconstruction.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace vs::sculpt {

// Where an element's value comes from: its centre, the part of its square that is inside, or sub-samples.
enum class Sampling { None, PolygonSmooth, Uniform, Jittered };
inline constexpr std::array<const char*, 4> kMaskSamplings{"none", "polygon", "uniform", "jittered"};
constexpr const auto& namesOf(Sampling) { return kMaskSamplings; }

// How an outline becomes grey values (thesis, section 3.5.2). Sampling::None takes each element's centre, 0
// or 1; PolygonSmooth the exact part of the element's square that the outline covers. Otherwise every element
// has kSubSamples^2 sub-samples, at the middles of their cells or jittered within them (seeded: the same
// outline always gives the same mask), and `width` of them along each axis, weighted by the reconstruction
// filter, make one value. Filters with negative lobes (Catmull-Rom, Mitchell-Netravali) overshoot on both
// sides of an edge; masks hold values from 0 to 1, so what goes beyond is cut off.
//
// Our reading of the thesis, section 3.6.2, which gives a cubic B-spline of "width 40" without saying what is
// counted: 40 sub-samples are the filter's whole support, four B-spline intervals of 10 sub-samples, and 10
// sub-samples span one element. So the filter has its natural size, one interval an element: it is symmetric,
// hence leaves the 0.5 level of straight edges on the outline, and rises from 0.1 to 0.9 within 1.5 elements.
// The natural widths are 10 for the box, 20 for the tent and 40 for the others.
struct MaskFilter {
    static constexpr int kSubSamples = 10;
    Sampling sampling = Sampling::Jittered;
    Reconstruction reconstruction = Reconstruction::BSpline;
    int width = 40; // in sub-samples
    std::uint32_t seed = 1;
};

// A mask: 1 inside, 0 outside, a smooth edge between. The centre of element (i, j) lies at origin + pitch *
// (i, j), in the outline's unit; x fastest.
struct MaskRaster {
    glm::ivec2 size{0};
    std::vector<float> values;
    glm::dvec2 origin{0};
    double pitch = 1;

    [[nodiscard]] float at(int i, int j) const {
        return values[std::size_t(j) * std::size_t(size.x) + std::size_t(i)];
    }
    // From the first to the last elements' centres.
    [[nodiscard]] MaskWindow window() const { return {origin, origin + pitch * glm::dvec2(size - 1)}; }
};

// For each element of a mask how many elements around it, along each axis and diagonal, hold the same value
// for sure. What lies beyond the raster is 0.
std::vector<std::uint16_t> flatness(const MaskRaster& mask);

// How many elements beyond an outline a mask may reach.
double filterReach(const MaskFilter& filter);

// Fills an outline by the even-odd rule (rings and self-crossings work). `pitch` is the distance between
// elements; they lie at multiples of it, with room around the outline for the whole smooth edge. An outline
// with fewer than three points gives an empty raster. Throws Error if the raster would have more than 64
// million elements.
MaskRaster rasterize(const Outline& outline, double pitch, const MaskFilter& filter = {});

} // namespace vs::sculpt
