// SPDX-License-Identifier: Apache-2.0
#include "render/slices/slice_renderer.h"

#include "base/check.h"
#include "base/timer.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <algorithm>

namespace vs::render {

namespace {

bool isSculpted(const SliceFrame& frame) {
    return frame.scene.sculpture != nullptr && frame.scene.view != field::SculptureView::Whole;
}

field::Detail::Layers layersOf(const SliceFrame& frame) {
    field::Detail::Layers layers;
    layers.hasCuts = isSculpted(frame) && frame.scene.hasFinerCuts;
    layers.hasSegments = frame.scene.segmentation != nullptr && frame.scene.hasFinerSegments;
    return layers;
}

gl::Defines definesFor(const SliceFrame& frame) {
    gl::Defines defines = gl::switchesOn({{"SCULPTED", isSculpted(frame)},
                                          {"SEGMENTED", frame.scene.segmentation != nullptr},
                                          {"TINTED", frame.tintsVisible},
                                          {"MARKS", frame.scene.marks != nullptr}});
    field::addFill(frame.scene, defines);
    if (frame.detail != nullptr) {
        frame.detail->addDefines(layersOf(frame), defines);
    }
    if (frame.tintsVisible && frame.classification != nullptr) {
        frame.classification->addDefines(defines);
    }
    return defines;
}

glm::ivec3 unit(int axis) {
    glm::ivec3 v(0);
    v[axis] = 1;
    return v;
}

} // namespace

void SliceRenderer::render(const SliceFrame& asked, double waitMs) {
    VS_CHECK(asked.scene.data != nullptr);
    const gl::Pass pass("draw slice");
    SliceFrame frame = asked;
    const SliceView& view = frame.view;
    const auto& grid = frame.scene.data->geometry;
    std::optional<int> level;
    if (frame.detail != nullptr) {
        level = frame.detail->levelFor(view.pixelMm / grid.stepMm());
    }
    if (glm::ivec2(picture_.size()) != view.size) {
        picture_ = gl::Texture(view.size, gl::Format::RGBA8, gl::Filter::Linear, "slice");
    }
    segmentColours_.writeValue(frame.segmentColours);
    const Timer timer;
    const glm::dvec3 middle =
        SliceGeometry(grid, view.kind).voxelAt(view.placeAt(0.5 * glm::dvec2(view.size)), view.index);
    missesBricks_ = false;
    while (true) {
        frame.detail = level ? frame.detail : nullptr;
        if (level) {
            frame.detail->use(*level);
        }
        draw(frame, draw_.with(definesFor(frame)));
        if (!level || frame.detail->endRound(middle) == 0) {
            return;
        }
        const double left = waitMs - timer.milliseconds();
        const bool hasChanged = frame.detail->deliver(std::max(left, 0.0));
        if (!hasChanged && frame.detail->isFull()) {
            level = frame.detail->coarserThan(*level); // there is no room for all of this one
        } else if (left <= 0) {
            missesBricks_ = true;
            return;
        }
    }
}

void SliceRenderer::draw(const SliceFrame& frame, gl::Program& program) {
    const SliceView& view = frame.view;
    const SliceGeometry geometry(frame.scene.data->geometry, view.kind);
    const glm::dvec3 first = geometry.voxelAt(view.placeAt({0.5, 0.5}), view.index);
    program.set("first", glm::vec3(first))
        .set("perRight", glm::vec3(geometry.voxelsPerMmRight() * view.pixelMm))
        .set("perDown", glm::vec3(geometry.voxelsPerMmDown() * view.pixelMm))
        .set("across", unit(geometry.acrossAxis()))
        .set("down", unit(geometry.downAxis()))
        .set("isSmooth", frame.isSmooth ? 1 : 0)
        .set("window", glm::vec2(frame.window.lo, frame.window.hi))
        .set("segmentLook", glm::vec2(frame.fill, frame.outlinePixels));
    segmentColours_.bindUniform(kSegmentColoursBlock);
    sceneBinding_.bind(frame.scene);
    if (frame.detail != nullptr) {
        frame.detail->bind(layersOf(frame));
    }
    if (frame.tintsVisible && frame.classification != nullptr) {
        frame.classification->bind();
    } else if (frame.tintsVisible) {
        program.set("visible", glm::vec2(frame.visible.lo, frame.visible.hi));
    }
    picture_.bindImage(kSlicePictureImage, gl::Access::Write);
    program.dispatchOver({view.size, 1}, gl::Barrier::All);
}

image::Image SliceRenderer::readPicture() const {
    image::Image image(picture_.size().x, picture_.size().y);
    const auto texels = picture_.download({glm::ivec3(0), picture_.size()});
    std::transform(texels.begin(), texels.end(), image.rgba.begin(),
                   [](std::byte value) { return std::uint8_t(value); });
    return image;
}

} // namespace vs::render
