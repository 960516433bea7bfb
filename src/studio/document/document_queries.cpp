// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"
#include "studio/document/document_state.h"
#include "studio/operations/sketch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

std::optional<Document::Probe> Document::probe(glm::dvec2 pixel, glm::ivec2 viewport) {
    const glm::vec2 position(pixel);
    const auto points = impl_->cutter.picker.pickPoints(
        impl_->frame(impl_->view, viewport), std::span(&position, 1), render::Picker::Meets::Brightest);
    if (points.front().voxel.w < 0.5F) {
        return std::nullopt;
    }
    const auto& geometry = impl_->volume.geometry;
    Probe probe;
    probe.voxel = glm::dvec3(points.front().voxel);
    probe.world = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(probe.voxel, 1.0));
    probe.value = interpolate(impl_->volume, probe.voxel);
    return probe;
}

std::vector<glm::dvec2> Document::outlineOnSurface(const Sketch& mask, glm::dvec2 pixel,
                                                   glm::ivec2 viewport) {
    const render::Frame frame = impl_->frame(impl_->view, viewport);
    const ToolMask toolMask(mask, frame, impl_->volume.geometry);
    const auto plane = layOnSurface(impl_->cutter.picker, frame, toolMask, pixel);
    std::vector<glm::dvec2> outline;
    if (plane) {
        for (const glm::dvec2 point : outlineOf(mask)) {
            outline.push_back(frame.rays.project(plane->place(point - toolMask.drawnAt)));
        }
    }
    return outline;
}

std::vector<std::vector<glm::dvec2>> Document::outlinesAlongPath(const Sweep& sweep) {
    Sweep op = sweep;
    impl_->settle(op.canvas);
    return sweptOutlines(impl_->cutter, impl_->frame(op.canvas->view, op.canvas->viewport), op);
}

Document::Steps Document::steps() const {
    Steps steps;
    const auto& done = impl_->history.done();
    const auto& undone = impl_->history.undone();
    steps.done = done.size();
    std::transform(done.begin(), done.end(), std::back_inserter(steps.operations),
                   [](const Step& step) { return &step.operation; });
    std::transform(undone.rbegin(), undone.rend(), std::back_inserter(steps.operations),
                   [](const Step& step) { return &step.operation; });
    return steps;
}

std::size_t Document::pastedParts() const { return impl_->pasted.sculptures.size(); }

Box3 Document::partBox(std::size_t part) {
    Box3 box;
    for (const glm::dvec3 middle : partCells(part)) {
        const glm::ivec3 cell = glm::ivec3(middle) / field::kCell;
        box = unite(box, {field::kCell * cell, field::kCell * (cell + 1)});
    }
    return intersect(box, impl_->volume.geometry.box());
}

std::vector<glm::dvec3> Document::partCells(std::size_t part) {
    const glm::ivec3 dims = impl_->volume.geometry.dims;
    const auto rangesOf = [&](const gl::Texture& texels) {
        gl::Texture cells(field::cellDims(dims), gl::Format::RG32F, gl::Filter::Nearest,
                          "cells of a pasted part");
        field::CellRangeUpdater().update(texels, {glm::ivec3(0), dims}, cells);
        return cells.downloadAll<glm::vec2>();
    };
    const auto& pastes = impl_->pasted.sculptures;
    std::vector<glm::vec2> cut;
    std::vector<glm::vec2> before; // cells that are still the same do not count
    if (part == pastes.size()) {
        cut = impl_->sculpture.cells().downloadAll<glm::vec2>();
        if (!pastes.empty()) {
            before = rangesOf(*pastes.back());
        }
    } else {
        const auto parts = impl_->frame(impl_->view, glm::ivec2(1)).pasted;
        if (part >= parts.size()) {
            return {};
        }
        cut = rangesOf(*parts[part].sculpture);
    }
    // More than half, because between two parts that touch both are half there.
    constexpr float kSurely = 0.6F;
    return impl_->seenCells(
        [&](std::size_t n) { return cut[n].y >= kSurely && (before.empty() || cut[n] != before[n]); });
}

std::vector<glm::dvec3> Document::remainingCells() {
    const auto cut = impl_->sculpture.cells().downloadAll<glm::vec2>();
    switch (impl_->view.sculptureView) {
    case field::SculptureView::Cut:
        return impl_->seenCells([&](std::size_t n) { return cut[n].x < 0.5F; });
    case field::SculptureView::Probe:
        return impl_->seenCells([&](std::size_t n) { return cut[n].y >= 0.5F; });
    case field::SculptureView::Whole:
        break;
    }
    return impl_->seenCells([](std::size_t) { return true; });
}

// The middles of the macrocells that hold values of the displayed range and for which `isThere` holds.
std::vector<glm::dvec3> Document::Impl::seenCells(const std::function<bool(std::size_t)>& isThere) {
    const glm::ivec3 cellDims = field::cellDims(volume.geometry.dims);
    const auto values = pipeline.cellRanges().cells.downloadAll<glm::vec2>();
    const Range shown = view.visibleRange(volume.range);
    std::vector<glm::dvec3> cells;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (values[n].y >= shown.lo && values[n].x <= shown.hi && isThere(n)) {
            const int i = int(n);
            const glm::ivec3 cell(i % cellDims.x, i / cellDims.x % cellDims.y, i / cellDims.x / cellDims.y);
            cells.push_back(double(field::kCell) * glm::dvec3(cell) + 0.5 * (field::kCell - 1));
        }
    }
    return cells;
}

render::TransferFunction Document::resolved(const render::TransferFunction& function) {
    return impl_->pipeline.resolved(function);
}

const std::vector<std::uint32_t>* Document::visibleHistogram(double budgetMs) {
    VS_CHECK(!isStrokeOpen());
    const auto view = impl_->view.sculptureView;
    if (view == field::SculptureView::Whole ||
        (view == field::SculptureView::Cut && impl_->sculpture.isEmpty())) {
        return &impl_->histogram;
    }
    auto& visible = impl_->visibleCounts;
    if (!visible) {
        visible.emplace(field::VisibleHistogram(impl_->field, int(impl_->histogram.size())));
    }
    const std::pair of(impl_->sculpture.contentVersion(), view);
    if (visible->of != of) {
        visible->counting.start(view);
        visible->of = of;
        visible->isDone = false;
    }
    if (!visible->isDone && visible->counting.advance(impl_->sculpture.texels(), budgetMs)) {
        visible->counts = visible->counting.counts();
        visible->isDone = true;
    }
    return visible->isDone ? &visible->counts : nullptr;
}

std::vector<std::byte> Document::sculptureBytes() const {
    return impl_->sculpture.download(impl_->volume.geometry.box());
}

bool Document::isCut() const { return !impl_->sculpture.isEmpty(); }

std::vector<float> Document::sculptureValues(const Box3& box) const { return impl_->sculpture.values(box); }

std::vector<float> Document::partValues(std::size_t place, const Box3& box) {
    const auto parts = impl_->frame(impl_->view, glm::ivec2(1)).pasted;
    VS_CHECK(place < parts.size());
    return sculpt::valuesOf(parts[place].sculpture->download(box), precision());
}

std::vector<std::uint32_t> Document::generations() const {
    return impl_->region.exists() ? impl_->region.growth()->generations(true)
                                  : std::vector<std::uint32_t>(impl_->volume.geometry.voxelCount(), 0);
}

std::vector<std::uint8_t> Document::labels() const {
    return impl_->region.exists() ? impl_->region.growth()->labels()
                                  : std::vector<std::uint8_t>(impl_->volume.geometry.voxelCount(), 0);
}

std::vector<std::uint8_t> Document::labelMap() const {
    return impl_->region.exists() ? impl_->region.growth()->labelMap()
                                  : std::vector<std::uint8_t>(impl_->volume.geometry.voxelCount(), 0);
}

Document::GrowthRules Document::growthRules() const {
    const segment::Constraints& rules = impl_->region.rules();
    GrowthRules result{rules.range, rules.difference, rules.gradient, rules.gradientDifference};
    result.connectivity = rules.connectivity == segment::Connectivity::TwentySix ? 26 : 6;
    result.isLive = impl_->region.exists() && impl_->region.growth()->state().isLive;
    return result;
}

std::size_t Document::voxelCount(std::uint8_t label) const {
    return impl_->region.exists() ? std::size_t(impl_->region.growth()->voxelCount(label)) : 0;
}

std::uint64_t Document::segmentsRevision() const {
    return impl_->region.exists() ? impl_->region.growth()->revision() : 0;
}

const SegmentList& Document::segments() const { return impl_->segments; }

} // namespace vs::studio
