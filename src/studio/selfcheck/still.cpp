// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/still.h"

namespace vs::studio {

Still::Still(volume::Volume v, const Range& displayed, const render::Camera& camera, glm::ivec2 size)
    : volume_(std::move(v)), field_(field::uploadVolume(volume_)), cells_(field::computeCellRanges(field_)) {
    frame_.scene.data = &field_;
    frame_.scene.displayedRange = displayed;
    frame_.scene.greyWindow = field_.range;
    frame_.macrocells = &macrocells_;
    frame_.background = render::backgroundFromName("black");
    look(camera, size);
}

void Still::look(const render::Camera& camera, glm::ivec2 size) {
    frame_.rays = render::viewRays(camera, volume_.geometry, size);
}

void Still::sculpt(const OfVoxel& part) {
    sculpture_ = textureOf(part, "self check sculpture");
    sculptureCells_ = rangesOf(sculpture_);
    frame_.scene.sculpture = &sculpture_;
}

void Still::segment(const OfVoxel& part) {
    segmentation_ = textureOf(part, "self check segment");
    segmentationCells_ = rangesOf(segmentation_);
    frame_.scene.segmentation = &segmentation_;
}

void Still::pasteInPlace() { frame_.pasted.push_back({{}, &sculpture_, &pastedMacrocells_}); }

void Still::classify(const render::TransferFunction& function) {
    classification_.update(function, field_);
    frame_.classification = &classification_;
}

gl::Texture Still::textureOf(const OfVoxel& part, const char* label) const {
    std::vector<float> values;
    forEachVoxel(volume_.geometry.box(),
                 [&](glm::ivec3 v, std::size_t) { values.push_back(float(part(glm::dvec3(v)))); });
    gl::Texture texture(volume_.geometry.dims, gl::Format::R32F, gl::Filter::Linear, label);
    texture.upload(volume_.geometry.box(), std::as_bytes(std::span(values)));
    return texture;
}

gl::Texture Still::rangesOf(const gl::Texture& texture) const {
    gl::Texture ranges(cells_.cells.size(), gl::Format::RG32F, gl::Filter::Nearest, "self check cells");
    field::CellRangeUpdater().update(texture, volume_.geometry.box(), ranges);
    return ranges;
}

void Still::rebuild(render::Mode mode) {
    frame_.mode = mode;
    const bool drawsSegments = frame_.scene.segmentation != nullptr && mode == render::Mode::Segment;
    render::Macrocells::Input input;
    input.dataCells = &cells_.cells;
    input.sculptureCells = frame_.scene.sculpture != nullptr ? &sculptureCells_ : nullptr;
    input.segmentationCells = drawsSegments ? &segmentationCells_ : nullptr;
    input.visibleRange = field::withTolerance(frame_.scene.displayedRange, field_);
    input.view = frame_.scene.view;
    input.sampling = frame_.scene.sampling;
    input.classification = mode == render::Mode::Volume ? frame_.classification : nullptr;
    macrocells_.rebuild(input);
    input.view = field::SculptureView::Probe;
    if (!frame_.pasted.empty()) {
        pastedMacrocells_.rebuild(input);
    }
}

image::Image Still::draw() {
    caster_.render(frame_);
    return caster_.readPicture();
}

image::Image Still::picture(render::Mode mode) {
    rebuild(mode);
    return draw();
}

image::Image Still::marchedPicture(render::Mode mode) {
    frame_.mode = mode;
    constexpr float much = 1e9F;
    const glm::ivec3 cells = cells_.cells.size();
    gl::Texture anything(cells, gl::Format::RG32F, gl::Filter::Nearest, "self check any value");
    const std::vector<glm::vec2> ranges(Box3{glm::ivec3(0), cells}.volume(), glm::vec2(-much, much));
    anything.upload({glm::ivec3(0), cells}, std::as_bytes(std::span(ranges)));
    render::Macrocells::Input input;
    input.dataCells = &anything;
    input.visibleRange = {-much, much};
    input.view = field::SculptureView::Whole;
    macrocells_.rebuild(input);
    auto picture = draw();
    rebuild(mode); // the ranges of any value are gone with this call
    return picture;
}

std::vector<field::SurfacePoint> Still::pick(render::Mode mode, render::Picker::Meets meets) {
    rebuild(mode);
    std::vector<glm::vec2> centres;
    for (int y = 0; y < size().y; ++y) {
        for (int x = 0; x < size().x; ++x) {
            centres.emplace_back(float(x) + 0.5F, float(y) + 0.5F);
        }
    }
    return picker_.pickPoints(frame_, centres, meets);
}

render::ViewRays::Ray Still::rayOf(glm::ivec2 pixel) const {
    return frame_.rays.through(glm::dvec2(pixel) + 0.5);
}

reference::Ray Still::plainRayOf(glm::ivec2 pixel) const {
    const auto ray = rayOf(pixel);
    return reference::rayThrough(volume_.geometry, ray.origin, ray.direction);
}

} // namespace vs::studio
