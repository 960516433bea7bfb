// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "base/math.h"
#include "volume/grid/geometry.h"

#include <array>

namespace vs::render {

enum class Projection { Perspective, Orthographic };
inline constexpr std::array<const char*, 2> kProjections{"perspective", "orthographic"};
constexpr const auto& namesOf(Projection) { return kProjections; }

// A viewer on an orbit around a target. Azimuth 0, elevation 0 looks at the patient's face with superior up;
// positive azimuth moves the viewer to the patient's left, positive elevation up (doc/behaviour.md,
// "Pictures"). Zoom 1 frames the volume; flying in is allowed. World is LPS millimetres.
struct Camera {
    static constexpr const char* kName = "camera";

    double azimuthDegrees = 0;
    double elevationDegrees = 0;
    double zoom = 1;
    glm::dvec2 panMm{0}; // target moved right and up in the picture plane
    Projection projection = Projection::Perspective;
    double rollDegrees = 0; // about the line of sight; positive turns the picture clockwise

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{written("azimuth", &Camera::azimuthDegrees, {.unit = "degrees"},
                                  "positive moves the viewer left"),
                          written("elevation", &Camera::elevationDegrees, {.unit = "degrees"},
                                  "positive moves the viewer up"),
                          written("roll", &Camera::rollDegrees, {.unit = "degrees"},
                                  "positive turns the picture clockwise"),
                          written("zoom", &Camera::zoom, {.least = 1e-3, .most = 1e3}, "1 frames the volume"),
                          written("pan", &Camera::panMm, {.unit = "mm"}),
                          written("projection", &Camera::projection)};
    }

    bool operator==(const Camera&) const = default;
};

// A camera in front of one volume and one viewport: everything a ray needs, in world space.
// The ray through viewport position `pixel` (pixel centres at + 0.5, y down) with n = 2 * pixel / size - 1 is
// origin eye, direction forward + n.x * right - n.y * up (perspective), or origin eye + n.x * right - n.y *
// up, direction forward (orthographic).
struct ViewRays {
    glm::dvec3 eye{0};
    glm::dvec3 forward{0}; // unit
    glm::dvec3 right{0}; // half the picture's width: per unit distance (perspective) or in mm (orthographic)
    glm::dvec3 up{0};    // half the picture's height, in the same unit
    glm::ivec2 size{1};
    bool isOrthographic = false;

    struct Ray {
        glm::dvec3 origin;
        glm::dvec3 direction; // unit
    };
    [[nodiscard]] Ray through(glm::dvec2 pixel) const;
    // Where a world point appears, in pixels.
    [[nodiscard]] glm::dvec2 project(glm::dvec3 world) const;
    // Width in mm of one pixel at the eye, and how much more it is for each mm along a ray.
    [[nodiscard]] glm::dvec2 pixelWidths() const;
    // Width in mm of one pixel at a world point.
    [[nodiscard]] double pixelMm(glm::dvec3 world) const;
};

ViewRays viewRays(const Camera& camera, const volume::GridGeometry& geometry, glm::ivec2 size);

// The least width in mm that a pixel has anywhere in the volume: where it is nearest to the viewer, 0 where
// the viewer is in it.
double leastPixelMm(const ViewRays& rays, const volume::GridGeometry& geometry);

// The pixels of the picture whose rays may pass through these voxels: the smallest rectangle around the box
// that they fill, or the whole picture where some of it is not in front of the viewer.
Box2 pixelsAround(const Box3& voxels, const ViewRays& rays, const volume::GridGeometry& geometry);

} // namespace vs::render
