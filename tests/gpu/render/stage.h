// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/cell_ranges.h"
#include "render/rays/picker.h"
#include "render/rays/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace vs::test {

// A document's worth of state for one volume: enough to render and pick in every mode. Sculpture and
// segmentation are functions of voxel coordinates, 0 to 1.
class Stage {
public:
    using VoxelFunction = std::function<double(glm::dvec3 voxel)>;

    explicit Stage(volume::Volume v, Range range)
        : volume(std::move(v)), field(field::uploadVolume(volume)), cells(field::computeCellRanges(field)) {
        frame.scene.data = &field;
        frame.scene.displayedRange = range;
        frame.scene.greyWindow = field.range;
        frame.macrocells = &macrocells;
        look({}, {200, 160});
        rebuild();
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void look(const render::Camera& camera, glm::ivec2 size) {
        frame.rays = render::viewRays(camera, volume.geometry, size);
    }

    // Black, so that a pixel's brightness is what its ray has seen and nothing else.
    void darken() { frame.background = render::backgroundFromName("black"); }

    void sculpt(const VoxelFunction& part) {
        sculpture = textureOf(part, "sculpture");
        frame.scene.sculpture = &sculpture;
        sculptureCells = rangesOf(sculpture);
        rebuild();
    }

    // Cuts away everything with voxel coordinate above `place` along `axis`: a linear ramp whose 0.5 level is
    // that plane.
    void cutAbove(double place, int axis = 0) {
        sculpt([=](glm::dvec3 p) { return std::clamp(0.5 + (p[axis] - place) / 4, 0.0, 1.0); });
    }

    void segment(const VoxelFunction& part) {
        segmentation = textureOf(part, "segmentation");
        frame.scene.segmentation = &segmentation;
        segmentationCells = rangesOf(segmentation);
        rebuild();
    }

    // Several segments: the memberships of opaque and of translucent ones, and which segment each voxel is
    // of.
    void segments(const VoxelFunction& opaque, const VoxelFunction& translucent, const VoxelFunction& label) {
        const auto memberships = valuesOf(opaque);
        const auto others = valuesOf(translucent);
        const auto numbers = valuesOf(label);
        std::vector<std::uint16_t> texels;
        std::vector<float> greater;
        for (std::size_t i = 0; i < memberships.size(); ++i) {
            texels.push_back(std::uint16_t(std::lround(65535 * memberships[i])));
            texels.push_back(std::uint16_t(std::lround(65535 * others[i])));
            greater.push_back(std::max(memberships[i], others[i]));
        }
        const std::vector<std::uint8_t> ofVoxels(numbers.begin(), numbers.end());
        segmentation = textureOf(std::span(texels), gl::Format::RG16, gl::Filter::Linear, "segmentation");
        segmentLabels = textureOf(std::span(ofVoxels), gl::Format::R8UI, gl::Filter::Nearest, "labels");
        segmentationCells = rangesOf(
            textureOf(std::span(greater), gl::Format::R32F, gl::Filter::Nearest, "greater membership"));
        frame.scene.segmentation = &segmentation;
        frame.scene.segmentLabels = &segmentLabels;
        rebuild();
    }

    void view(field::SculptureView seen) {
        frame.scene.view = seen;
        rebuild();
    }

    void classify(const render::TransferFunction& function) {
        classification.update(function, field);
        frame.classification = &classification;
        rebuild();
    }

    void paste(const std::vector<render::Placement>& placements) {
        frame.pasted.clear();
        for (const auto& place : placements) {
            frame.pasted.push_back({place, &sculpture, &pastedMacrocells});
        }
        rebuild();
    }

    void rebuild() {
        auto input = cellsInput();
        macrocells.rebuild(input);
        if (!frame.pasted.empty()) {
            input.view = field::SculptureView::Probe;
            pastedMacrocells.rebuild(input);
        }
    }

    image::Image picture(render::Mode mode) {
        frame.mode = mode;
        rebuild();
        return draw();
    }

    // A picture with every macrocell counted as occupied, by any value: plain marching.
    image::Image marchedPicture(render::Mode mode) {
        frame.mode = mode;
        constexpr float much = 1e9F;
        gl::Texture anything(cells.cells.size(), gl::Format::RG32F, gl::Filter::Nearest, "any value");
        const std::vector<glm::vec2> ranges(std::size_t(anything.size().x) * std::size_t(anything.size().y) *
                                                std::size_t(anything.size().z),
                                            glm::vec2(-much, much));
        anything.upload({glm::ivec3(0), anything.size()}, std::as_bytes(std::span(ranges)));
        render::Macrocells::Input input;
        input.dataCells = &anything;
        input.visibleRange = {-much, much};
        input.view = field::SculptureView::Whole;
        macrocells.rebuild(input);
        auto picture = draw();
        rebuild();
        return picture;
    }

    std::vector<field::SurfacePoint> points(const std::vector<glm::vec2>& pixels) {
        return picker.pickPoints(frame, pixels);
    }

    volume::Volume volume;
    field::Field field;
    field::CellRanges cells;
    gl::Texture sculpture;
    gl::Texture sculptureCells;
    gl::Texture segmentation;
    gl::Texture segmentationCells;
    gl::Texture segmentLabels;
    render::Classification classification;
    render::Macrocells macrocells;
    render::Macrocells pastedMacrocells;
    render::RayCaster caster;
    render::Picker picker;
    render::Frame frame;

private:
    [[nodiscard]] render::Macrocells::Input cellsInput() const {
        const bool drawsSegmentation =
            frame.scene.segmentation != nullptr &&
            (frame.mode == render::Mode::Overlay || frame.mode == render::Mode::Segment ||
             frame.mode == render::Mode::Volume);
        render::Macrocells::Input input;
        input.dataCells = &cells.cells;
        input.sculptureCells = frame.scene.sculpture != nullptr ? &sculptureCells : nullptr;
        input.segmentationCells = drawsSegmentation ? &segmentationCells : nullptr;
        Range visible = frame.scene.displayedRange;
        if (frame.scene.showsAbove) {
            visible.hi = std::max(visible.hi, field.range.hi);
        }
        input.visibleRange = field::withTolerance(visible, field);
        input.view = frame.scene.view;
        input.sampling = frame.scene.sampling;
        input.classification = frame.mode == render::Mode::Volume ? frame.classification : nullptr;
        return input;
    }

    image::Image draw() {
        caster.render(frame);
        return caster.readPicture();
    }

    std::vector<float> valuesOf(const VoxelFunction& part) const {
        const glm::ivec3 dims = volume.geometry.dims;
        std::vector<float> values;
        for (int k = 0; k < dims.z; ++k) {
            for (int j = 0; j < dims.y; ++j) {
                for (int i = 0; i < dims.x; ++i) {
                    values.push_back(float(part({i, j, k})));
                }
            }
        }
        return values;
    }

    template <typename T>
    gl::Texture textureOf(std::span<T> values, gl::Format format, gl::Filter filter,
                          const char* label) const {
        gl::Texture texture(volume.geometry.dims, format, filter, label);
        texture.upload(volume.geometry.box(), std::as_bytes(values));
        return texture;
    }

    gl::Texture textureOf(const VoxelFunction& part, const char* label) const {
        const auto values = valuesOf(part);
        return textureOf(std::span(values), gl::Format::R32F, gl::Filter::Linear, label);
    }

    gl::Texture rangesOf(const gl::Texture& texture) const {
        gl::Texture ranges(cells.cells.size(), gl::Format::RG32F, gl::Filter::Nearest, "cells");
        field::CellRangeUpdater().update(texture, volume.geometry.box(), ranges);
        return ranges;
    }
};

inline std::vector<glm::vec2> allPixels(glm::ivec2 size, int every) {
    std::vector<glm::vec2> pixels;
    for (int y = 0; y < size.y; y += every) {
        for (int x = 0; x < size.x; x += every) {
            pixels.emplace_back(float(x) + 0.5F, float(y) + 0.5F);
        }
    }
    return pixels;
}

} // namespace vs::test
