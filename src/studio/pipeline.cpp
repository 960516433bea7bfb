// SPDX-License-Identifier: Apache-2.0
#include "studio/pipeline.h"

namespace vs::studio {

Pipeline::Pipeline(const field::Field& field)
    : field_(&field), cellRanges_(field::computeCellRanges(field)) {}

namespace {

// What volume mode shows when no transfer function was chosen: the displayed range, denser from its lower end
// up.
render::TransferFunction functionOfRange(const Range& range) {
    render::TransferFunction function;
    function.name = "displayed range";
    function.colours = render::SpreadColours{"ivory", range};
    const double full = range.lo + 0.25 * (range.hi - range.lo);
    function.points = {{range.lo, 0}, {full, 0.3}, {range.hi, 0.3}, {range.hi, 0}};
    return function;
}

} // namespace

const render::Classification* Pipeline::classify(const View& view) {
    if (!view.transferFunction && view.mode != render::Mode::Volume) {
        return nullptr;
    }
    if (!classification_) {
        classification_.emplace();
    }
    classification_->update(view.transferFunction ? *view.transferFunction : functionOfRange(view.range),
                            *field_);
    return &*classification_;
}

render::Frame Pipeline::frame(const State& state, glm::ivec2 size) {
    const View& view = *state.view;
    const bool drawsSegmentation = view.mode == render::Mode::Overlay || view.mode == render::Mode::Segment;
    if (drawsSegmentation && state.growth != nullptr) {
        if (!segmentation_) {
            segmentation_.emplace(field_->geometry);
        }
        segmentation_->update(*state.growth);
    }
    const bool hasSegmentation = drawsSegmentation && segmentation_ && state.growth != nullptr;
    const bool isSculpted = !state.sculpture->isEmpty();

    // With nothing cut yet the volume is drawn whole, in probe view too: there must be something to draw on.
    render::Frame frame;
    frame.scene.data = field_;
    frame.scene.sculpture = isSculpted ? &state.sculpture->texels() : nullptr;
    frame.scene.segmentation = hasSegmentation ? &segmentation_->texels() : nullptr;
    frame.scene.displayedRange = view.range;
    frame.scene.greyWindow = state.greyWindow;
    frame.scene.view = isSculpted ? view.sculptureView : field::SculptureView::Whole;
    frame.scene.sampling = view.sampling;
    frame.rays = render::viewRays(view.camera, field_->geometry, size);
    frame.mode = view.mode;
    frame.classification = classify(view);
    const bool byFunction = view.mode == render::Mode::Volume;

    Key key{view.range,
            frame.scene.view,
            state.sculpture->version(),
            hasSegmentation ? segmentation_->version() : 0,
            hasSegmentation,
            byFunction ? classification_->version() : 0,
            view.sampling};
    refresh(cells_, key, state, frame);
    frame.macrocells = &cells_.macrocells;
    if (isSculpted && !view.pasted.empty()) {
        key.view = field::SculptureView::Probe;
        refresh(pastedCells_, key, state, frame);
        frame.pasted = view.pasted;
        frame.pastedMacrocells = &pastedCells_.macrocells;
    }
    return frame;
}

void Pipeline::refresh(Cells& cells, const Key& key, const State& state, const render::Frame& frame) {
    const auto& old = cells.key;
    // In probe view a cut adds to what is seen, so there nothing can be kept.
    const bool mayKeep = state.cuttingSince && old && old->sculptureVersion == *state.cuttingSince &&
                         old->view != field::SculptureView::Probe &&
                         key.view != field::SculptureView::Probe && old->range == key.range &&
                         old->functionVersion == key.functionVersion && old->sampling == key.sampling &&
                         old->drawsSegmentation == key.drawsSegmentation &&
                         old->segmentationVersion == key.segmentationVersion;
    if (mayKeep || old == key) {
        return;
    }
    render::Macrocells::Input input;
    input.dataCells = &cellRanges_.cells;
    input.sculptureCells = frame.scene.sculpture != nullptr ? &state.sculpture->cells() : nullptr;
    input.segmentationCells = key.drawsSegmentation ? &segmentation_->cells() : nullptr;
    input.displayedRange = key.range;
    input.valueTolerance = field::valueTolerance(*field_);
    input.view = key.view;
    input.sampling = key.sampling;
    input.classification = frame.mode == render::Mode::Volume ? frame.classification : nullptr;
    cells.macrocells.rebuild(input);
    cells.key = key;
}

} // namespace vs::studio
