// SPDX-License-Identifier: Apache-2.0
#include "render/rays/picker.h"

#include "gl/pass.h"

namespace vs::render {

namespace {
#include "render/shaders/bindings.glsl"
} // namespace

Picker::Picker() : view_(sizeof(ViewBlock), "picker view") {}

gl::Program& Picker::programFor(const Frame& frame, Meets meets) {
    const bool isSculpted =
        frame.scene.sculpture != nullptr || frame.scene.view == field::SculptureView::Probe;
    const bool picksMaximum = frame.mode == Mode::Mip && meets != Meets::Surface;
    // In overlay and segment mode a stroke lands on whatever surface is seen; in MIP and X-ray on the
    // displayed range's; in volume mode on what the transfer function makes opaque, or a segment's surface.
    const bool byFunction = frame.mode == Mode::Volume;
    const bool isOverlay = frame.mode == Mode::Overlay;
    const int content = isOverlay && meets == Meets::Segment       ? 1
                        : isOverlay || frame.mode == Mode::Segment ? 2
                        : byFunction                               ? 3
                                                                   : 0;
    const int kind = byFunction ? int(frame.classification->kind()) : 0;
    const bool isTricubic = frame.scene.sampling == field::Sampling::Tricubic;
    const bool isSmoothed = frame.scene.smoothed != nullptr;
    const bool hasQuads = bool((isSmoothed ? frame.scene.smoothed : frame.scene.data)->quads);
    const bool meetsSegments = byFunction && frame.scene.segmentation != nullptr;
    auto& program = programs_[(isSculpted ? 1 : 0) + (picksMaximum ? 2 : 0) + 4 * content + 16 * kind +
                              (isTricubic ? 64 : 0) + (hasQuads ? 128 : 0) + (isSmoothed ? 256 : 0) +
                              (meetsSegments ? 512 : 0)];
    if (!program) {
        gl::Defines defines{{"CONTENT", std::to_string(content)}};
        if (isSculpted) {
            defines.emplace_back("SCULPTED", "1");
        }
        if (isSmoothed) {
            defines.emplace_back("SMOOTHED", "1");
        }
        if (isTricubic) {
            defines.emplace_back("TRICUBIC", "1");
        }
        if (hasQuads) {
            defines.emplace_back("QUADS", "1");
        }
        if (byFunction) {
            defines.emplace_back("TF_KIND", frame.classification->kindDefine());
        }
        if (meetsSegments) {
            defines.emplace_back("SEGMENTS", "1");
        }
        if (picksMaximum) {
            defines.emplace_back("PICK_MAXIMUM", "1");
        }
        program = gl::Program("render/shaders/pick_points.comp", defines);
    }
    return program;
}

field::SurfacePoints Picker::pick(const Frame& frame, std::span<const glm::vec2> positions, Meets meets) {
    const gl::Pass pass("pick surface points");
    field::SurfacePoints out;
    out.size = {int(positions.size()), 1};
    out.points = gl::Buffer(positions.size() * sizeof(field::SurfacePoint), "surface points");
    if (positions.empty()) {
        return out;
    }
    gl::Program& program = programFor(frame, meets);
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
    program.dispatchOverList(positions.size(), gl::Barrier::Storage);
    return out;
}

std::vector<field::SurfacePoint> Picker::pickPoints(const Frame& frame, std::span<const glm::vec2> positions,
                                                    Meets meets) {
    return pick(frame, positions, meets).points.read<field::SurfacePoint>(positions.size());
}

} // namespace vs::render
