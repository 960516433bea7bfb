// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <optional>
#include <vector>

namespace vs::studio {

class Cutter;
class Display;
struct Contents;

// A point of the volume and the value there.
struct Probe {
    glm::dvec3 voxel{0};
    glm::dvec3 world{0};
    double value = 0;
};

// What lies under a pixel of the present view, and how what is drawn lies on it. Pixels are those of a
// viewport of the given size, or of the operation's canvas.
class SurfaceQueries {
public:
    // All three must outlive it.
    SurfaceQueries(const Contents& contents, Display& display, Cutter& cutter)
        : contents_(contents), display_(display), cutter_(cutter) {}

    // Value and place of the surface point under a pixel. Nothing if the ray meets nothing.
    std::optional<Probe> probe(glm::dvec2 pixel, glm::ivec2 viewport);

    // How a mask drawn on a canvas of the present view lies on the surface under a pixel: its outline there,
    // in pixels. Empty if nothing is under the pixel. For the laser's preview.
    std::vector<glm::dvec2> outlineOnSurface(const Sketch& mask, glm::dvec2 pixel, glm::ivec2 viewport);
    // The outlines of a sweep's mask here and there along its path, in pixels of its canvas.
    std::vector<std::vector<glm::dvec2>> outlinesAlongPath(const Sweep& sweep);

private:
    const Contents& contents_;
    Display& display_;
    Cutter& cutter_;
};

} // namespace vs::studio
