// SPDX-License-Identifier: Apache-2.0
#include "render/rays/picker.h"

#include "gl/pass.h"
#include "render/shaders/bindings.h"

namespace vs::render {

namespace {

gl::Defines definesFor(const Frame& frame, Picker::Meets meets) {
    const field::Scene& scene = frame.scene;
    const field::Field& searched = scene.smoothed != nullptr ? *scene.smoothed : *scene.data;
    // In overlay and segment mode a stroke lands on whatever surface is seen; in MIP and X-ray on the
    // displayed range's; in volume mode on what the transfer function makes opaque, or a segment's surface.
    const bool byFunction = frame.mode == Mode::Volume;
    const bool isOverlay = frame.mode == Mode::Overlay;
    const int content = isOverlay && meets == Picker::Meets::Segment ? 1
                        : isOverlay || frame.mode == Mode::Segment   ? 2
                        : byFunction                                 ? 3
                                                                     : 0;
    gl::Defines defines = gl::switchesOn({
        {"SCULPTED", scene.sculpture != nullptr || scene.view == field::SculptureView::Probe},
        {"SMOOTHED", scene.smoothed != nullptr},
        {"TRICUBIC", scene.sampling == field::Sampling::Tricubic},
        {"QUADS", bool(searched.quads)},
        {"SEGMENTS", byFunction && scene.segmentation != nullptr},
        {"PICK_MAXIMUM", frame.mode == Mode::Mip && meets != Picker::Meets::Surface},
    });
    defines.emplace_back("CONTENT", std::to_string(content));
    if (byFunction) {
        frame.classification->addDefines(defines);
    }
    return defines;
}

} // namespace

Picker::Picker() : view_(sizeof(ViewBlock), "picker view") {}

field::SurfacePoints Picker::pick(const Frame& frame, std::span<const glm::vec2> positions, Meets meets) {
    const gl::Pass pass("pick surface points");
    field::SurfacePoints out;
    out.size = {int(positions.size()), 1};
    out.points = gl::Buffer(positions.size() * sizeof(field::SurfacePoint), "surface points");
    if (positions.empty()) {
        return out;
    }
    gl::Program& program = pickPoints_.with(definesFor(frame, meets));
    sceneBinding_.bind(frame.scene);
    view_.writeValue(viewBlock(frame.rays, frame.scene.data->geometry));
    view_.bindUniform(kViewBlock);
    frame.macrocells->bind();
    if (frame.mode == Mode::Volume) {
        frame.classification->bind();
    }
    positions_.reserve(positions.size_bytes());
    positions_.write(positions);
    positions_.bindStorage(kPositionsStorage);
    out.points.bindStorage(kPointsStorage);
    program.set("count", int(positions.size()));
    // Read at once; and what was looked at as textures may be cut next.
    program.dispatchOverList(positions.size(), gl::Barrier::All);
    return out;
}

std::vector<field::SurfacePoint> Picker::pickPoints(const Frame& frame, std::span<const glm::vec2> positions,
                                                    Meets meets) {
    return pick(frame, positions, meets).points.read<field::SurfacePoint>(positions.size());
}

} // namespace vs::render
