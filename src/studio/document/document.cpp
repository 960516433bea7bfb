// SPDX-License-Identifier: Apache-2.0
#include "studio/document/document.h"

#include "base/check.h"
#include "field/histogram.h"
#include "studio/document/document_state.h"
#include "studio/operations/sketch.h"

#include <cmath>

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

} // namespace

Document::Impl::Impl(volume::Volume v, sculpt::Precision precision)
    : volume(std::move(v)), field(field::uploadVolume(volume)),
      histogram(field::intensityHistogram(field, histogramBins(field))),
      sculpture(volume.geometry.dims, precision), pipeline(field), region(field, sculpture),
      cutter(field, sculpture) {
    view.range = field::suggestRange(histogram, volume.range);
    if (volume.range.width() <= 0) { // one value all over: all of it is the object
        view.range = {volume.range.lo - 0.5, volume.range.hi + 0.5};
    } else if (field.isIntegral) {
        view.range.lo = std::ceil(view.range.lo);
    }
    grey = volume.range.width() > 0 ? greyWindow(histogram, volume.range, view.range.lo)
                                    : Range{volume.range.lo - 3, volume.range.hi + 1};
    loggedView = view;
}

Pipeline::State Document::Impl::stateOf(const View& from) {
    Pipeline::State state;
    state.view = &from;
    state.sculpture = &sculpture;
    state.pasted = &pasted;
    state.growth = region.growth();
    state.segments = &segments;
    state.smoothing = scrubbedFrom ? segment::Smoothing::Plain : segment::Smoothing::Smooth;
    state.greyWindow = grey;
    if (stroke && stroke->onlyCuts()) {
        state.cuttingSince = stroke->sculptureVersion();
    }
    return state;
}

render::Frame Document::Impl::frame(const View& from, glm::ivec2 size) {
    return pipeline.frame(stateOf(from), size);
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

Document::Document(volume::Volume volume, sculpt::Precision precision)
    : impl_(std::make_unique<Impl>(std::move(volume), precision)) {}
Document::~Document() = default;

const volume::Volume& Document::volume() const { return impl_->volume; }
sculpt::Precision Document::precision() const { return impl_->sculpture.precision(); }
const field::Field& Document::field() const { return impl_->field; }
const std::vector<std::uint32_t>& Document::histogram() const { return impl_->histogram; }
const View& Document::view() const { return impl_->view; }
const std::vector<Operation>& Document::log() const { return impl_->log; }
bool Document::canUndo() const { return impl_->history.canUndo(); }
bool Document::canRedo() const { return impl_->history.canRedo(); }
const Operation* Document::lastStep() const { return canUndo() ? &impl_->history.lastOperation() : nullptr; }
std::uint64_t Document::version() const { return impl_->version; }
void Document::setUndoMemory(std::size_t bytes) { impl_->history.setMemoryLimit(bytes); }
UndoStatistics Document::undoStatistics() const { return impl_->history.statistics(); }

Outcome Document::apply(const Operation& operation, const std::filesystem::path& outputFolder) {
    VS_CHECK(!isStrokeOpen() && !isGrowing() && !isScrubbing());
    const Timer timer;
    Operation resolved = operation;
    const View before = impl_->view; // an operation may change where parts are pasted
    const bool hasLooked = !(before == impl_->loggedView);
    Outcome outcome = std::visit([&](auto& op) { return impl_->run(op, outputFolder); }, resolved);
    outcome.name = name(operation);
    if (std::holds_alternative<SetView>(resolved)) {
        impl_->log.push_back(std::move(resolved));
    } else {
        if (hasLooked) {
            impl_->log.emplace_back(lookAs(before));
        }
        impl_->log.push_back(std::move(resolved));
        impl_->loggedView = impl_->view;
    }
    outcome.milliseconds = timer.milliseconds();
    return outcome;
}

void Document::logOutput(const Operation& operation) {
    VS_CHECK(isOutput(operation));
    impl_->record(operation);
}

void Document::look(const View& view) {
    if (!(view == impl_->view)) {
        impl_->view = view;
        ++impl_->version;
    }
}

render::Frame Document::frame(glm::ivec2 size, double segmentsMs) {
    Pipeline::State state = impl_->stateOf(impl_->view);
    state.segmentsMs = segmentsMs;
    return impl_->pipeline.frame(state, size);
}

render::SliceFrame Document::slice(const render::SliceView& view, double segmentsMs) {
    Pipeline::State state = impl_->stateOf(impl_->view);
    state.segmentsMs = segmentsMs;
    return impl_->pipeline.slice(state, view);
}

bool Document::isBehind() const { return impl_->pipeline.isBehind(); }

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

Operation Document::openStroke() const {
    VS_CHECK(isStrokeOpen());
    return impl_->stroke->operation();
}

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
    impl_->discardStroke();
}

// --- live growth

void Document::seal() { impl_->sealed = impl_->log.size(); }

Outcome Document::rewindFurther(int generations) {
    const bool continues = impl_->log.size() > impl_->sealed &&
                           std::holds_alternative<Rewind>(impl_->log.back()) &&
                           impl_->view == impl_->loggedView && !canRedo() && canUndo() &&
                           std::holds_alternative<Rewind>(impl_->history.lastOperation());
    Outcome outcome = apply(Rewind{generations});
    if (continues) {
        impl_->history.mergeLastTwo();
        impl_->log.pop_back();
        std::get<Rewind>(impl_->log.back()).generations += generations;
        impl_->history.lastOperation() = impl_->log.back();
    }
    return outcome;
}

void Document::scrub(int generation) {
    VS_CHECK(!isStrokeOpen() && !isGrowing() && impl_->region.hasSeeds());
    if (!isScrubbing()) {
        impl_->scrubbedFrom = impl_->region.growth()->playhead();
    }
    impl_->region.scrub(generation);
    ++impl_->version;
}

bool Document::isScrubbing() const { return impl_->scrubbedFrom.has_value(); }

Outcome Document::endScrub() {
    VS_CHECK(isScrubbing());
    const int generation = impl_->region.growth()->playhead();
    impl_->region.scrub(*impl_->scrubbedFrom);
    impl_->scrubbedFrom.reset();
    return apply(ShowGeneration{generation});
}

void Document::beginGrowth() {
    VS_CHECK(!isStrokeOpen() && !isGrowing() && !isScrubbing());
    Impl::LiveGrowth live;
    live.voxelsBefore = impl_->grownVoxels();
    live.sculptureView = impl_->view.sculptureView;
    impl_->workUnlocked(live.records);
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

} // namespace vs::studio
