// SPDX-License-Identifier: Apache-2.0
// Which of cast_rays.comp's variants a frame needs.
#include "render/rays/ray_caster.h"

namespace vs::render {

bool RayCaster::drawsTranslucent(const Frame& frame) {
    const bool drawsSurfaces =
        frame.mode == Mode::Overlay || frame.mode == Mode::Segment || frame.mode == Mode::Volume;
    return drawsSurfaces && frame.scene.segmentation != nullptr && frame.segmentColours.haveTranslucent();
}

bool RayCaster::showsMarks(const Frame& frame) {
    return frame.scene.marks != nullptr && frame.mode != Mode::Mip && frame.mode != Mode::XRay;
}

namespace {

// Whether segments are shown in a mode that can do without: as surfaces in volume mode, by their colours in
// MIP and X-ray.
bool addsSegments(const Frame& frame) {
    return (frame.mode == Mode::Volume || frame.mode == Mode::Mip || frame.mode == Mode::XRay) &&
           frame.scene.segmentation != nullptr;
}

} // namespace

// Where maxima are looked for, their ranges are bound where the segments of finer levels would be.
field::Detail::Layers RayCaster::layersOf(const Frame& frame) {
    const field::Scene& scene = frame.scene;
    const bool isSculpted = scene.sculpture != nullptr || scene.view == field::SculptureView::Probe;
    field::Detail::Layers layers;
    layers.hasCuts = frame.detail != nullptr && isSculpted && scene.hasFinerCuts;
    layers.hasSegments = frame.detail != nullptr && frame.mode != Mode::Mip &&
                         scene.segmentation != nullptr && scene.hasFinerSegments;
    return layers;
}

gl::Defines RayCaster::definesFor(const Frame& frame) {
    const field::Scene& scene = frame.scene;
    const bool isLit = frame.mode != Mode::Mip && frame.mode != Mode::XRay; // these have no surfaces
    const field::Field& searched = scene.smoothed != nullptr ? *scene.smoothed : *scene.data;
    const bool isSculpted = field::hasHiddenSide(scene);
    gl::Defines defines = gl::switchesOn({
        {"SCULPTED", isSculpted},
        {"CUT_ALONG_SEGMENTS", isSculpted && scene.isCutAlongSegments && scene.segmentation != nullptr},
        {"LIT", frame.occlusion != nullptr && isLit},
        {"PARTS", !frame.pasted.empty() || !frame.pulled.empty()},
        {"QUADS", bool(searched.quads) && frame.detail == nullptr},
        {"BRICK_RANGES", frame.detail != nullptr && frame.detail->hasTellingRanges(field::kCell)},
        {"SMOOTHED", scene.smoothed != nullptr},
        {"TRICUBIC", scene.sampling == field::Sampling::Tricubic},
        {"SEGMENTS", addsSegments(frame)},
        {"TRANSLUCENT", drawsTranslucent(frame)},
        {"MARKS", showsMarks(frame)},
    });
    if (frame.detail != nullptr) {
        frame.detail->addDefines(layersOf(frame), defines);
    }
    field::addFill(scene, defines);
    defines.emplace_back("MODE", std::to_string(static_cast<int>(frame.mode)));
    if (frame.classification != nullptr) {
        frame.classification->addDefines(defines);
    }
    return defines;
}

// The same but for light and content. In surface mode, where segments have no colour, it has its own all the
// same.
gl::Defines RayCaster::definesFor(const Frame& frame, const PulledSegment& segment) {
    Frame alone = frame;
    alone.occlusion = nullptr;
    alone.mode = frame.mode == Mode::Surface ? Mode::Segment : frame.mode;
    alone.scene.smoothed = nullptr;
    alone.scene.fill = nullptr;
    // What is apart has tiles of its own where those would be bound.
    alone.scene.hasFinerCuts = segment.scene.hasFinerCuts && segment.scene.apartPages == nullptr;
    alone.scene.hasFinerSegments = segment.scene.hasFinerSegments && segment.scene.apartPages == nullptr;
    if (frame.mode == Mode::Surface) {
        alone.segmentColours = {}; // no glass
    }
    gl::Defines defines = definesFor(alone);
    const auto more = gl::switchesOn({
        {"PULLED", true},
        {"APART", segment.scene.apartPages != nullptr},
        {"ALL_SEGMENTS", frame.mode == Mode::Surface},
    });
    defines.insert(defines.end(), more.begin(), more.end());
    // It may be drawn where segments are not.
    Frame own = alone;
    own.scene.segmentation = segment.scene.segmentation;
    if (layersOf(own).hasSegments && !layersOf(alone).hasSegments) {
        defines.emplace_back("FINER_SEGMENTS", frame.detail->segmentKinds());
    }
    return defines;
}

} // namespace vs::render
