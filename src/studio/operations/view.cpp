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
            view.tintsSegments, view.sliceWindow, view.tintsSlices, view.isInverted};
}

} // namespace vs::studio
