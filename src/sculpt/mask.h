// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vs::sculpt {

// A closed polygon (the last point joins the first), in pixels for drawn masks and in voxels for sweeps.
using Outline = std::vector<glm::dvec2>;

// A drawn closed curve as it is; consecutive equal points are dropped.
Outline freeFormOutline(std::span<const glm::dvec2> points);
Outline ellipseOutline(glm::dvec2 centre, glm::dvec2 radii);
Outline circleOutline(glm::dvec2 centre, double radius);
// `a` and `b` are opposite corners.
Outline rectangleOutline(glm::dvec2 a, glm::dvec2 b);
// Corners joined by straight lines, closed.
Outline polylineOutline(std::span<const glm::dvec2> corners);

enum class Sampling { None, Uniform, Jittered };
enum class Reconstruction { Box, BSpline };

// How an outline becomes grey values. Sampling::None takes each element's centre, 0 or 1. Otherwise every
// element has kSubSamples^2 sub-samples, at the middles of their cells or jittered within them (seeded: the
// same outline always gives the same mask), and `width` of them along each axis, weighted by the
// reconstruction filter, make one value.
//
// Reading of thesis 3.5.2, which gives a cubic B-spline of "width 40" without saying what is counted: 40
// sub-samples are the filter's whole support, four B-spline intervals of 10 sub-samples, and 10 sub-samples
// span one element. So the filter has its natural size, one interval an element: it is symmetric, hence
// leaves the 0.5 level of straight edges on the outline, and rises from 0.1 to 0.9 within 1.5 elements.
struct MaskFilter {
    static constexpr int kSubSamples = 10;
    Sampling sampling = Sampling::Jittered;
    Reconstruction reconstruction = Reconstruction::BSpline;
    int width = 40; // in sub-samples; for Box 10 is one element
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
};

// Fills an outline by the even-odd rule (rings and self-crossings work). `pitch` is the distance between
// elements; they lie at multiples of it, with room around the outline for the whole smooth edge. An outline
// with fewer than three points gives an empty raster. Throws Error if the raster would have more than 64
// million elements.
MaskRaster rasterize(const Outline& outline, double pitch, const MaskFilter& filter = {});

// The cubic B-spline, support [-2, 2] (thesis 3.5.2, as corrected in the errata).
double cubicBSpline(double x);

} // namespace vs::sculpt
