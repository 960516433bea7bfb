// SPDX-License-Identifier: Apache-2.0
// Which of cast_rays.comp's variants a frame needs.
#include "render/rays/ray_caster.h"

namespace vs::render {

bool RayCaster::drawsTranslucent(const Frame& frame) {
    const bool drawsSurfaces =
        frame.mode == Mode::Overlay || frame.mode == Mode::Segment || frame.mode == Mode::Volume;
    return drawsSurfaces && frame.scene.segmentation != nullptr && frame.segmentColours.haveTranslucent();
}

namespace {

// Whether segments are shown in a mode that can do without: as surfaces in volume mode, by their colours in
// MIP and X-ray.
bool addsSegments(const Frame& frame) {
    return (frame.mode == Mode::Volume || frame.mode == Mode::Mip || frame.mode == Mode::XRay) &&
           frame.scene.segmentation != nullptr;
}

// CONTENT in surface.glsl.
int contentOf(const Frame& frame) {
    return frame.mode == Mode::Segment                                                          ? 2
           : frame.mode == Mode::Overlay || (frame.mode == Mode::Volume && addsSegments(frame)) ? 1
                                                                                                : 0;
}

} // namespace

gl::Program& RayCaster::programFor(const Frame& frame) {
    const bool isSculpted =
        frame.scene.sculpture != nullptr || frame.scene.view == field::SculptureView::Probe;
    const bool isTricubic = frame.scene.sampling == field::Sampling::Tricubic;
    const int kind = frame.classification != nullptr ? 1 + int(frame.classification->kind()) : 0;
    const bool isLit = frame.occlusion != nullptr;
    const bool hasParts = !frame.pasted.empty();
    const bool isSmoothed = frame.scene.smoothed != nullptr;
    const bool hasQuads = bool((isSmoothed ? frame.scene.smoothed : frame.scene.data)->quads);
    const bool hasTranslucent = drawsTranslucent(frame);
    const bool hasAddedSegments = addsSegments(frame);
    const bool hasSegmentCells = frame.segmentCells != nullptr;
    const int key = (hasSegmentCells ? 16384 : 0) + (hasAddedSegments ? 8192 : 0) + (isSmoothed ? 4096 : 0) +
                    256 * static_cast<int>(frame.mode) + (hasTranslucent ? 128 : 0) + (hasQuads ? 64 : 0) +
                    16 * kind + (hasParts ? 8 : 0) + (isLit ? 4 : 0) + (isTricubic ? 2 : 0) +
                    (isSculpted ? 1 : 0);
    auto& program = programs_[key];
    if (!program) {
        gl::Defines defines{{"MODE", std::to_string(static_cast<int>(frame.mode))},
                            {"CONTENT", std::to_string(contentOf(frame))}};
        if (isSculpted) {
            defines.emplace_back("SCULPTED", "1");
        }
        if (isLit) {
            defines.emplace_back("LIT", "1");
        }
        if (hasParts) {
            defines.emplace_back("PARTS", "1");
        }
        if (hasQuads) {
            defines.emplace_back("QUADS", "1");
        }
        if (isSmoothed) {
            defines.emplace_back("SMOOTHED", "1");
        }
        if (isTricubic) {
            defines.emplace_back("TRICUBIC", "1");
        }
        if (hasAddedSegments) {
            defines.emplace_back("SEGMENTS", "1");
        }
        if (hasSegmentCells) {
            defines.emplace_back("SEGMENT_CELLS", "1");
        }
        if (hasTranslucent) {
            defines.emplace_back("TRANSLUCENT", "1");
        }
        if (frame.classification != nullptr) {
            defines.emplace_back("TF_KIND", frame.classification->kindDefine());
        }
        program = gl::Program("render/shaders/cast_rays.comp", defines);
    }
    return program;
}

} // namespace vs::render
