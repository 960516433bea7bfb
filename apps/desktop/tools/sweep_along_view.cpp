// SPDX-License-Identifier: Apache-2.0
#include "tools/sweep_along_view.h"

#include "sculpt/path/path.h"
#include "studio/document/surface_queries.h"
#include "studio/operations/sketch.h"

#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kOutsideSteps = 4; // begins beside the surface, so that all of it goes

// The drawn outline in steps about (0, 0), turned so that what is up in the picture is up for the mask where
// its way begins.
studio::Sketch maskInSteps(const studio::Sketch& drawn, const sculpt::MaskFrame& first, glm::dvec3 upInSteps,
                           double stepsPerPixel) {
    const glm::dvec2 up(glm::dot(upInSteps, first.x), glm::dot(upInSteps, first.y));
    const double angle = glm::length(up) > 1e-6 ? std::atan2(-up.x, up.y) : 0.0;
    const glm::dmat2 turn(std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle));
    const auto outline = studio::outlineOf(drawn);
    const glm::dvec2 centre = studio::centreOf(outline);
    studio::Sketch mask{studio::Shape::Polyline, {}};
    for (const glm::dvec2 pixel : outline) {
        mask.points.push_back(turn * (stepsPerPixel * (pixel - centre) * glm::dvec2(1, -1)));
    }
    return mask;
}

} // namespace

studio::Sweep sweepAlongView(const studio::Sketch& mask, const studio::Probe& start,
                             const SweepTool::Settings& settings, const studio::Canvas& canvas,
                             const volume::GridGeometry& geometry) {
    const auto rays = render::viewRays(canvas.view.camera, geometry, canvas.viewport);
    const glm::dvec3 direction = rays.through(rays.project(start.world)).direction;
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    const glm::dvec3 voxelsPerStep = geometry.stepMm() / geometry.spacing();
    const auto stepsAt = [&](double depth) {
        const glm::dvec3 world = start.world + depth * geometry.stepMm() * direction;
        return glm::dvec3(voxelFromWorld * glm::dvec4(world, 1.0)) / voxelsPerStep;
    };
    const std::vector<glm::dvec3> ends{stepsAt(-kOutsideSteps), stepsAt(settings.length)};

    studio::Sweep sweep;
    std::vector<sculpt::PathPiece> pieces;
    if (settings.way == SweepTool::Way::Helix) {
        sweep.path.kind = studio::SweepPath::Kind::Helix;
        sweep.path.helixRadius = settings.helixRadius;
        sweep.path.turns = settings.turns;
        pieces = sculpt::helixPath({ends[0], ends[1], settings.helixRadius, settings.turns}, settings.frame);
    } else {
        sweep.path.kind = studio::SweepPath::Kind::Polyline;
        pieces = sculpt::polylinePath(ends, settings.frame);
    }
    for (const glm::dvec3& end : ends) {
        sweep.path.points.push_back(voxelsPerStep * end);
    }
    if (!pieces.empty()) {
        const glm::dvec3 up = glm::dmat3(voxelFromWorld) * rays.up / voxelsPerStep;
        sweep.mask =
            maskInSteps(mask, pieces.front().from, up, rays.pixelMm(start.world) / geometry.stepMm());
    }
    return sweep;
}

} // namespace vs::desktop
