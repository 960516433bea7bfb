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

SetView setViewTo(const View& view) {
    return {view.camera,       view.mode,     view.range,   view.sculptureView, view.transferFunction,
            view.pasted,       view.sampling, view.shadows, view.hidesAbove,    view.surfaceSmoothing,
            view.tintsSegments};
}

} // namespace vs::studio
