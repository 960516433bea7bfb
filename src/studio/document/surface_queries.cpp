// SPDX-License-Identifier: Apache-2.0
#include "studio/document/surface_queries.h"

#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/operations/sketch.h"
#include "studio/strokes/cutter.h"
#include "studio/strokes/pen_stroke.h"
#include "studio/strokes/sweep_stroke.h"

namespace vs::studio {

namespace {

// The value between voxels, as the picture shows it: on a surface it is the displayed range's end.
double interpolate(const volume::Volume& volume, glm::dvec3 voxel) {
    const glm::ivec3 base(glm::floor(voxel));
    const glm::dvec3 part = voxel - glm::dvec3(base);
    double value = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::equal(offset, glm::ivec3(1)));
        value += weight.x * weight.y * weight.z *
                 volume.at(glm::clamp(base + offset, glm::ivec3(0), volume.geometry.dims - 1));
    }
    return value;
}

} // namespace

std::optional<Probe> SurfaceQueries::probe(glm::dvec2 pixel, glm::ivec2 viewport) {
    const glm::vec2 position(pixel);
    const auto points = cutter_.picker.pickPoints(display_.frame(contents_.view, viewport),
                                                  std::span(&position, 1), render::Picker::Meets::Brightest);
    if (points.front().voxel.w < 0.5F) {
        return std::nullopt;
    }
    const auto& geometry = contents_.scan.volume.geometry;
    Probe probe;
    probe.voxel = glm::dvec3(points.front().voxel);
    probe.world = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(probe.voxel, 1.0));
    // A little behind the surface: on it rounding would decide.
    const glm::dvec3 inwards =
        glm::dmat3(geometry.voxelFromWorld()) * -glm::dvec3(points.front().normal) * geometry.stepMm();
    const std::uint8_t material = contents_.filled.fill->materialAt(probe.voxel + 0.3 * inwards);
    const bool isMaterial = material != 0 && contents_.filled.materials->at(material - 1U).isVisible &&
                            contents_.view.sculptureView != field::SculptureView::Probe;
    probe.value = isMaterial ? contents_.filled.materials->at(material - 1U).value
                             : interpolate(contents_.scan.volume, probe.voxel);
    return probe;
}

std::vector<glm::dvec2> SurfaceQueries::outlineOnSurface(const Sketch& mask, glm::dvec2 pixel,
                                                         glm::ivec2 viewport) {
    const render::Frame frame = display_.frame(contents_.view, viewport);
    const ToolMask toolMask(mask, frame, contents_.scan.volume.geometry);
    const auto plane = layOnSurface(cutter_, frame, toolMask, pixel);
    std::vector<glm::dvec2> outline;
    if (plane) {
        for (const glm::dvec2 point : outlineOf(mask)) {
            outline.push_back(frame.rays.project(plane->place(point - toolMask.drawnAt)));
        }
    }
    return outline;
}

std::vector<std::vector<glm::dvec2>> SurfaceQueries::outlinesAlongPath(const Sweep& sweep) {
    Sweep op = sweep;
    contents_.fillIn(op.canvas);
    return sweptOutlines(cutter_, display_.frame(op.canvas->view, op.canvas->viewport), op);
}

} // namespace vs::studio
