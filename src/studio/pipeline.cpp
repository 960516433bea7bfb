// SPDX-License-Identifier: Apache-2.0
#include "studio/pipeline.h"

namespace vs::studio {

Pipeline::Pipeline(const field::Field& field) : field_(&field), cells_(field::computeCellRanges(field)) {}

namespace {

// What volume mode shows when no transfer function was chosen: the displayed range, denser from its lower end up.
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
    classification_->update(view.transferFunction ? *view.transferFunction : functionOfRange(view.range), *field_);
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

    const Key key{view.range,
                  frame.scene.view,
                  state.sculpture->version(),
                  hasSegmentation ? segmentation_->version() : 0,
                  hasSegmentation,
                  byFunction ? classification_->version() : 0,
                  view.sampling};
    // In probe view a cut adds to what is seen, so there nothing can be kept.
    const bool mayKeep = state.cuttingSince && key_ && key_->sculptureVersion == *state.cuttingSince &&
                         key_->view != field::SculptureView::Probe &&
                         key.view != field::SculptureView::Probe && key_->range == key.range &&
                         key_->functionVersion == key.functionVersion && key_->sampling == key.sampling &&
                         key_->drawsSegmentation == key.drawsSegmentation &&
                         key_->segmentationVersion == key.segmentationVersion;
    if (!mayKeep && key_ != key) {
        render::Macrocells::Input input;
        input.dataCells = &cells_.cells;
        input.sculptureCells = isSculpted ? &state.sculpture->cells() : nullptr;
        input.segmentationCells = hasSegmentation ? &segmentation_->cells() : nullptr;
        input.displayedRange = view.range;
        input.valueTolerance = field::valueTolerance(*field_);
        input.view = frame.scene.view;
        input.sampling = view.sampling;
        input.classification = byFunction ? frame.classification : nullptr;
        macrocells_.rebuild(input);
        key_ = key;
    }
    frame.macrocells = &macrocells_;
    return frame;
}

} // namespace vs::studio
