// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/names.h"
#include "studio/operations/view.h"

#include <array>

namespace vs::studio {

inline constexpr double kFarthestPixel = 1e6; // of the viewport, or anywhere about it
inline constexpr Rule kPixels{.least = -kFarthestPixel, .most = kFarthestPixel, .unit = "pixels"};
inline constexpr Rule kTwoPixels{.least = -kFarthestPixel,
                                 .most = kFarthestPixel,
                                 .unit = "pixels",
                                 .leastCount = 2,
                                 .mostCount = 2,
                                 .wrongCount = "this shape takes exactly two points"};
inline constexpr Rule kVoxel{.least = 0, .most = 1 << 20, .unit = "voxels"};
inline constexpr Rule kFinestVoxel{.least = 0, .most = 1 << 20, .unit = "voxels of the finest level"};
inline constexpr Rule kPictureSize{.least = 1, .most = 16384, .unit = "pixels"};
inline constexpr int kMostPixels = 1 << 26;       // of a picture: 8192 x 8192
inline constexpr int kMostCanvasPixels = 1 << 25; // of a window: what the largest screens have
// What is wrong with a size whose two numbers are right one by one, of a member.
Fault faultOfSize(const char* member, glm::ivec2 size, int mostPixels);

enum class Shape { FreeForm, Ellipse, Circle, Rectangle, Polyline, Stencil };
inline constexpr std::array<const char*, 6> kShapes{"free-form", "ellipse",  "circle",
                                                    "rectangle", "polyline", "stencil"};
constexpr const auto& namesOf(Shape) { return kShapes; }

// What the pen drew, in viewport pixels (y down): for FreeForm and Polyline the points themselves, for
// Ellipse, Circle and Rectangle two opposite corners of the box around it (for Circle the first point is the
// centre, the second on the rim), for Stencil the outline of what a picture shows, always closed.
struct Sketch {
    static constexpr const char* kName = "sketch";

    Shape shape = Shape::FreeForm;
    std::vector<glm::dvec2> points;

    [[nodiscard]] constexpr bool isInBox() const {
        return shape == Shape::Ellipse || shape == Shape::Circle || shape == Shape::Rectangle;
    }

    template <typename = void>
    static constexpr auto fields() {
        constexpr auto isInBox = [](const Sketch& sketch) { return sketch.isInBox(); };
        constexpr auto isOfPoints = [](const Sketch& sketch) { return !sketch.isInBox(); };
        return std::tuple{
            required("shape", &Sketch::shape).deciding(),
            required("points", &Sketch::points, kPixels).when(isOfPoints),
            required("points", &Sketch::points, kTwoPixels,
                     "opposite corners of the box around it; of a circle the centre and a point of the rim")
                .when(isInBox)};
    }

    bool operator==(const Sketch&) const = default;
};

// On what an edit was drawn.
struct Canvas {
    static constexpr const char* kName = "canvas";

    View view;
    glm::ivec2 viewport{1230, 870}; // pixels

    template <typename = void>
    static constexpr auto fields() {
        constexpr auto of = [](auto member) { return through(&Canvas::view, member); };
        return std::tuple{required("viewport", &Canvas::viewport, kPictureSize),
                          required("camera", of(&View::camera)),
                          required("mode", of(&View::mode)),
                          required("range", of(&View::range)),
                          required("sculptureView", of(&View::sculptureView)),
                          written("sampling", of(&View::sampling)),
                          sparse("transferFunction", of(&View::transferFunction), {.mayBeNull = true}),
                          sparse("hideAbove", of(&View::hidesAbove)),
                          sparse("smoothSurface", of(&View::surfaceSmoothing), kSurfaceSmoothing),
                          sparse("pasted", of(&View::pasted), kPlacements)};
    }

    [[nodiscard]] Fault faultOf() const;
    bool operator==(const Canvas&) const = default;
};

// Where a round brush has gone in the volume: the voxels whose centres lie within the radius of its way, a
// line through points in voxel space, and those that the way itself runs through, so that a thin brush leaves
// no gaps. With an axis (0 to 2) the brush is a disc across that voxel axis, on the slice that its first
// point lies in; without, a ball.
struct Trail {
    static constexpr const char* kName = "trail";
    static constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

    std::vector<glm::dvec3> points;
    double radiusMm = 0;
    std::optional<int> axis = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("points", &Trail::points,
                     {.least = -1e6, .most = 1e6, .unit = "voxels", .leastCount = 1}),
            written("radius", &Trail::radiusMm, {.least = 0, .most = 1e4, .unit = "mm"}),
            sparse("axis", &Trail::axis, {.choices = kAxes}, "a disc across that axis instead of a ball")};
    }

    bool operator==(const Trail&) const = default;
};

} // namespace vs::studio
