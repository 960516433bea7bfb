// SPDX-License-Identifier: Apache-2.0
#include "studio/pipeline.h"

namespace vs::studio {

Pipeline::Pipeline(const field::Field& field) : field_(&field), cells_(field::computeCellRanges(field)) {}

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

    const Key key{view.range, frame.scene.view, state.sculpture->version(),
                  hasSegmentation ? segmentation_->version() : 0, hasSegmentation, view.sampling};
    // In probe view a cut adds to what is seen, so there nothing can be kept.
    const bool mayKeep = state.cuttingSince && key_ && key_->sculptureVersion == *state.cuttingSince &&
                         key_->view != field::SculptureView::Probe &&
                         key.view != field::SculptureView::Probe && key_->range == key.range &&
                         key_->drawsSegmentation == key.drawsSegmentation && key_->sampling == key.sampling &&
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
        macrocells_.rebuild(input);
        key_ = key;
    }
    frame.macrocells = &macrocells_;
    return frame;
}

} // namespace vs::studio
