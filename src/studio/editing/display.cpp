// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/display.h"

namespace vs::studio {

Pipeline::State Display::stateOf(const View& from, double segmentsMs) const {
    Pipeline::State state;
    state.view = &from;
    state.sculpture = &contents_->sculpture;
    state.trimmed = &contents_->trimmed;
    state.pasted = &contents_->pasted;
    state.growth = contents_->region.growth();
    state.finest = contents_->inHand == InHand::Scrub ? nullptr : contents_->region.finest();
    state.segments = &contents_->segments;
    state.isCutAlongSegments = contents_->isCutAlongSegments();
    state.smoothing = contents_->inHand == InHand::Scrub || !from.smoothsSegments
                          ? segment::Smoothing::Plain
                          : segment::Smoothing::Smooth;
    state.segmentsMs = segmentsMs;
    state.marks = contents_->marks;
    state.filled = contents_->filled;
    state.greyWindow = contents_->scan.grey;
    state.cuttingSince = contents_->cuttingSince;
    return state;
}

render::Frame Display::frame(const View& from, glm::ivec2 size, double segmentsMs) {
    return pipeline_.frame(stateOf(from, segmentsMs), size);
}

render::SliceFrame Display::slice(const render::SliceView& view, double segmentsMs) {
    Pipeline::State state = stateOf(contents_->view, segmentsMs);
    if (contents_->inHand == InHand::Growth) {
        state.finest = nullptr; // as drafts are: it is followed at once
    }
    render::SliceFrame frame = pipeline_.slice(state, view);
    frame.window = contents_->view.sliceWindow.value_or(contents_->scan.slices);
    return frame;
}

} // namespace vs::studio
