// SPDX-License-Identifier: Apache-2.0
#include "render/slices/slice_renderer.h"

#include "base/check.h"
#include "gl/pass.h"
#include "render/shaders/bindings.h"

#include <algorithm>

namespace vs::render {

namespace {

gl::Defines definesFor(const SliceFrame& frame) {
    gl::Defines defines = gl::switchesOn(
        {{"SCULPTED", frame.scene.sculpture != nullptr && frame.scene.view != field::SculptureView::Whole},
         {"SEGMENTED", frame.scene.segmentation != nullptr},
         {"TINTED", frame.tintsVisible}});
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

void SliceRenderer::render(const SliceFrame& frame) {
    VS_CHECK(frame.scene.data != nullptr);
    const gl::Pass pass("draw slice");
    const SliceView& view = frame.view;
    if (glm::ivec2(picture_.size()) != view.size) {
        picture_ = gl::Texture(view.size, gl::Format::RGBA8, gl::Filter::Linear, "slice");
    }
    const SliceGeometry geometry(frame.scene.data->geometry, view.kind);
    const glm::dvec3 first = geometry.voxelAt(view.placeAt({0.5, 0.5}), view.index);
    gl::Program& program = draw_.with(definesFor(frame));
    program.set("first", glm::vec3(first))
        .set("perRight", glm::vec3(geometry.voxelsPerMmRight() * view.pixelMm))
        .set("perDown", glm::vec3(geometry.voxelsPerMmDown() * view.pixelMm))
        .set("across", unit(geometry.acrossAxis()))
        .set("down", unit(geometry.downAxis()))
        .set("isSmooth", frame.isSmooth ? 1 : 0)
        .set("window", glm::vec2(frame.window.lo, frame.window.hi))
        .set("segmentLook", glm::vec2(frame.fill, frame.outlinePixels));
    segmentColours_.upload({glm::ivec3(0), segmentColours_.size()},
                           std::as_bytes(std::span(frame.segmentColours.entries)));
    segmentColours_.bindTexture(kSegmentColoursTexture);
    sceneBinding_.bind(frame.scene);
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
