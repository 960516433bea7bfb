// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/view.h"

#include <algorithm>

namespace vs::studio {

bool View::showsAbove() const {
    return !hidesAbove &&
           (mode == render::Mode::Mip || mode == render::Mode::XRay || mode == render::Mode::Overlay);
}

Range View::visibleRange(const Range& data) const {
    return {range.lo, showsAbove() ? std::max(range.hi, data.hi) : range.hi};
}

bool View::differsInSlicesOnly(const View& other) const {
    View same = other;
    same.sliceWindow = sliceWindow;
    same.tintsSlices = tintsSlices;
    return same == *this && !(other == *this);
}

SetView setViewTo(const View& view) {
    return {view.camera,        view.mode,        view.range,       view.sculptureView, view.transferFunction,
            view.pasted,        view.sampling,    view.shadows,     view.hidesAbove,    view.surfaceSmoothing,
            view.tintsSegments, view.sliceWindow, view.tintsSlices, view.isInverted,    view.smoothsSegments,
            view.spread};
}

View changed(View view, const SetView& by) {
    view.camera = by.camera.value_or(view.camera);
    view.mode = by.mode.value_or(view.mode);
    view.range = by.range.value_or(view.range);
    view.sculptureView = by.sculptureView.value_or(view.sculptureView);
    view.transferFunction = by.transferFunction.value_or(view.transferFunction);
    view.pasted = by.pasted.value_or(view.pasted);
    view.sampling = by.sampling.value_or(view.sampling);
    view.shadows = by.shadows.value_or(view.shadows);
    view.hidesAbove = by.hidesAbove.value_or(view.hidesAbove);
    view.surfaceSmoothing = by.surfaceSmoothing.value_or(view.surfaceSmoothing);
    view.tintsSegments = by.tintsSegments.value_or(view.tintsSegments);
    view.sliceWindow = by.sliceWindow.value_or(view.sliceWindow);
    view.tintsSlices = by.tintsSlices.value_or(view.tintsSlices);
    view.isInverted = by.isInverted.value_or(view.isInverted);
    view.smoothsSegments = by.smoothsSegments.value_or(view.smoothsSegments);
    view.spread = by.spread.value_or(view.spread);
    return view;
}

} // namespace vs::studio
