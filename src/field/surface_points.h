// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/buffer.h"

namespace vs::field {

// One surface point as shaders see it (std430, two vec4). Found by casting a ray through an element of a
// mask.
struct SurfacePoint {
    glm::vec4 voxel{0};  // xyz position in voxel space, w 1 = hit, 0 = the ray met nothing
    glm::vec4 normal{0}; // xyz unit normal in world space, facing the viewer; w distance from the eye in mm
};
static_assert(sizeof(SurfacePoint) == 32);

// The surface under a raster of rays: width * height points, x fastest. Where sculpt and segment get their
// places from; filled by render::Picker.
struct SurfacePoints {
    gl::Buffer points;
    glm::ivec2 size{0};
};

} // namespace vs::field
