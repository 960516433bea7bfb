// SPDX-License-Identifier: Apache-2.0
#include "studio/document.h"

#include "base/check.h"
#include "field/histogram.h"
#include "studio/document_state.h"
#include "studio/sketch.h"

#include <cmath>
#include <utility>

namespace vs::studio {

namespace {

// Greys of cut faces: the values of the object (those above `objectFrom`) without the rarest hundredth at
// either end.
Range greyWindow(const std::vector<std::uint32_t>& histogram, const Range& range, double objectFrom) {
    const double binWidth = range.width() / double(histogram.size());
    const auto countsFrom = [&](std::size_t bin) {
        return range.lo + double(bin + 1) * binWidth > objectFrom;
    };
    double total = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        total += countsFrom(i) ? histogram[i] : 0;
    }
    Range window{range.lo, range.hi};
    double seen = 0;
    for (std::size_t i = 0; i < histogram.size(); ++i) {
        const double before = seen;
        seen += countsFrom(i) ? histogram[i] : 0;
        if (before <= 0.01 * total && seen > 0.01 * total) {
            window.lo = range.lo + double(i) * binWidth;
        }
        if (before < 0.97 * total && seen >= 0.97 * total) {
            window.hi = range.lo + double(i + 1) * binWidth;
        }
    }
    // The darkest tissue of the object is dark grey, not black.
    window.lo = std::max(range.lo, window.lo - 0.25 * window.width());
    return window;
}

// 256 bins, or one for each step from value to value where whole numbers are fewer: bins of uneven size would
// comb.
int histogramBins(const field::Field& field) {
    return field.isIntegral ? std::clamp(int(std::min(field.range.width(), 256.0)), 1, 256) : 256;
}

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

Document::Impl::Impl(volume::Volume v)
    : volume(std::move(v)), field(field::uploadVolume(volume)),
      histogram(field::intensityHistogram(field, histogramBins(field))), sculpture(volume.geometry.dims),
      pipeline(field), region(field, sculpture), cutter(field, sculpture) {
    view.range = field::suggestRange(histogram, volume.range);
    if (field.isIntegral) {
        view.range.lo = std::ceil(view.range.lo);
    }
    grey = greyWindow(histogram, volume.range, view.range.lo);
    loggedView = view;
}

render::Frame Document::Impl::frame(const View& from, glm::ivec2 size) {
    Pipeline::State state;
    state.view = &from;
    state.sculpture = &sculpture;
    state.pasted = &pasted;
    state.growth = region.growth();
    state.greyWindow = grey;
    if (stroke && stroke->onlyCuts()) {
        state.cuttingSince = stroke->sculptureVersion();
    }
    return pipeline.frame(state, size);
}

void Document::Impl::settle(std::optional<Canvas>& canvas) const {
    if (!canvas) {
        canvas = Canvas{view, Canvas{}.viewport};
    }
}

void Document::Impl::record(Operation operation) {
    if (!(view == loggedView)) {
        log.emplace_back(lookAs(view));
        loggedView = view;
    }
    log.push_back(std::move(operation));
}

void Document::Impl::remember(Operation operation, std::optional<sculpt::BrickDelta> cut,
                              Region::Records growth) {
    history.push({std::move(operation), std::move(cut), std::move(growth)});
    ++version;
}

Document::Document(volume::Volume volume) : impl_(std::make_unique<Impl>(std::move(volume))) {}
Document::~Document() = default;

const volume::Volume& Document::volume() const { return impl_->volume; }
const field::Field& Document::field() const { return impl_->field; }
const std::vector<std::uint32_t>& Document::histogram() const { return impl_->histogram; }
const View& Document::view() const { return impl_->view; }
const std::vector<Operation>& Document::log() const { return impl_->log; }
bool Document::canUndo() const { return impl_->history.canUndo(); }
bool Document::canRedo() const { return impl_->history.canRedo(); }
const Operation* Document::lastStep() const {
    return canUndo() ? &std::as_const(impl_->history).toUndo().operation : nullptr;
}
std::uint64_t Document::version() const { return impl_->version; }

Outcome Document::apply(const Operation& operation, const std::filesystem::path& outputFolder) {
    VS_CHECK(!isStrokeOpen() && !isGrowing());
    const Timer timer;
    Operation resolved = operation;
    Outcome outcome = std::visit([&](auto& op) { return impl_->run(op, outputFolder); }, resolved);
    outcome.name = name(operation);
    if (std::holds_alternative<SetView>(resolved)) {
        impl_->log.push_back(std::move(resolved));
    } else {
        impl_->record(std::move(resolved));
    }
    outcome.milliseconds = timer.milliseconds();
    return outcome;
}

void Document::note(const Operation& operation) {
    VS_CHECK(isOutput(operation));
    impl_->record(operation);
}

void Document::look(const View& view) {
    if (!(view == impl_->view)) {
        impl_->view = view;
        ++impl_->version;
    }
}

render::Frame Document::frame(glm::ivec2 size) { return impl_->frame(impl_->view, size); }

// --- live strokes

void Document::beginStroke(Operation operation) {
    VS_CHECK(!isStrokeOpen() && !isGrowing());
    std::visit(
        [&](auto& op) {
            if constexpr (requires { op.canvas; }) {
                impl_->settle(op.canvas);
            }
        },
        operation);
    impl_->beginStroke(operation);
}

void Document::updatePeel(double layers) {
    VS_CHECK(isStrokeOpen());
    dynamic_cast<PeelStroke&>(*impl_->stroke).peelTo(layers);
    ++impl_->version;
}

void Document::updatePen(const sculpt::PenPoint& pen) {
    VS_CHECK(isStrokeOpen());
    dynamic_cast<PenStroke&>(*impl_->stroke).drawAt(pen);
    ++impl_->version;
}

void Document::updateClip(const Clip& clip) {
    VS_CHECK(isStrokeOpen());
    dynamic_cast<ClipStroke&>(*impl_->stroke).clipTo(clip);
    ++impl_->version;
}

bool Document::isStrokeOpen() const { return impl_->stroke != nullptr; }

Outcome Document::commitStroke() {
    VS_CHECK(isStrokeOpen());
    const Operation operation = impl_->stroke->operation();
    Outcome outcome = impl_->endStroke();
    outcome.name = name(operation);
    outcome.milliseconds = impl_->strokeTimer.milliseconds();
    if (outcome.voxelsTouched > 0) {
        impl_->record(operation);
    }
    return outcome;
}

void Document::discardStroke() {
    VS_CHECK(isStrokeOpen());
    impl_->stroke->discard();
    impl_->stroke.reset();
    ++impl_->version;
}

// --- live growth

Outcome Document::rewindFurther(int generations) {
    const bool continues = !impl_->log.empty() && std::holds_alternative<Rewind>(impl_->log.back()) &&
                           impl_->view == impl_->loggedView && !canRedo() && canUndo() &&
                           std::holds_alternative<Rewind>(impl_->history.toUndo().operation);
    Outcome outcome = apply(Rewind{generations});
    if (continues) {
        impl_->history.mergeLastTwo();
        impl_->log.pop_back();
        std::get<Rewind>(impl_->log.back()).generations += generations;
        impl_->history.toUndo().operation = impl_->log.back();
    }
    return outcome;
}

void Document::beginGrowth() {
    VS_CHECK(!isStrokeOpen() && !isGrowing());
    Impl::LiveGrowth live;
    live.voxelsBefore = impl_->grownVoxels();
    live.sculptureView = impl_->view.sculptureView;
    impl_->region.beginLive(live.sculptureView, live.records);
    impl_->live = std::move(live);
}

bool Document::growFor(double budgetMs, int maxGenerations) {
    VS_CHECK(isGrowing());
    impl_->live->generations += impl_->region.growFor(budgetMs, maxGenerations);
    ++impl_->version;
    return !impl_->region.growth()->isFinished();
}

bool Document::isGrowing() const { return impl_->live.has_value(); }

Outcome Document::endGrowth() {
    VS_CHECK(isGrowing());
    Impl::LiveGrowth live = std::move(*impl_->live);
    impl_->live.reset();
    impl_->region.endLive(live.records);
    Outcome outcome = impl_->describeGrowth(live.generations, live.voxelsBefore);
    const Operation operation = Grow{live.generations, live.sculptureView};
    outcome.name = name(operation);
    outcome.milliseconds = live.timer.milliseconds();
    if (live.generations > 0) {
        impl_->remember(operation, {}, std::move(live.records));
        impl_->record(operation);
    } else {
        impl_->region.undo(live.records); // nothing grew: as if it had not begun
    }
    return outcome;
}

Document::GrowthStatus Document::growth() const {
    GrowthStatus status;
    if (const segment::Growth* growth = impl_->region.growth()) {
        status.generation = growth->playhead();
        status.extent = growth->extent();
        status.voxels = std::size_t(growth->voxelCount());
        status.millilitres = double(status.voxels) * impl_->volume.geometry.voxelMm3() / 1000;
        status.range = growth->constraints().range;
        status.hasSeeds = impl_->region.hasSeeds();
    }
    return status;
}

// --- asking

std::optional<Document::Probe> Document::probe(glm::dvec2 pixel, glm::ivec2 viewport) {
    const glm::vec2 position(pixel);
    const auto points =
        impl_->cutter.picker.pickPoints(impl_->frame(impl_->view, viewport), std::span(&position, 1));
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

std::size_t Document::pastedParts() const { return impl_->pasted.sculptures.size(); }

Box3 Document::partBox(std::size_t part) {
    const glm::ivec3 dims = impl_->volume.geometry.dims;
    const glm::ivec3 cellDims = field::cellDims(dims);
    const auto rangesOf = [&](const gl::Texture& texels) {
        gl::Texture cells(cellDims, gl::Format::RG32F, gl::Filter::Nearest, "cells of a pasted part");
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
    const auto values = impl_->pipeline.cellRanges().cells.downloadAll<glm::vec2>();
    const Range& shown = impl_->view.range;
    // More than half, because between two parts that touch both are half there.
    constexpr float kSurely = 0.6F;
    Box3 box;
    for (std::size_t n = 0; n < cut.size(); ++n) {
        const bool isCut = cut[n].y >= kSurely && (before.empty() || cut[n] != before[n]);
        if (isCut && values[n].y >= shown.lo && values[n].x <= shown.hi) {
            const int i = int(n);
            const glm::ivec3 cell(i % cellDims.x, i / cellDims.x % cellDims.y, i / cellDims.x / cellDims.y);
            box = unite(box, {field::kCell * cell, field::kCell * (cell + 1)});
        }
    }
    return intersect(box, {glm::ivec3(0), dims});
}

std::vector<std::byte> Document::sculptureBytes() const {
    return impl_->sculpture.download(impl_->volume.geometry.box());
}

std::vector<std::uint32_t> Document::generations() const {
    return impl_->region.exists() ? impl_->region.growth()->generations(true)
                                  : std::vector<std::uint32_t>(impl_->volume.geometry.voxelCount(), 0);
}

std::vector<std::uint8_t> Document::labels() const {
    return impl_->region.exists() ? impl_->region.growth()->labels()
                                  : std::vector<std::uint8_t>(impl_->volume.geometry.voxelCount(), 0);
}

} // namespace vs::studio
