// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/operation.h"

#include "studio/operations/operation_names.h"

#include <algorithm>

namespace vs::studio {

bool View::showsAbove() const {
    return !hidesAbove &&
           (mode == render::Mode::Mip || mode == render::Mode::XRay || mode == render::Mode::Overlay);
}

Range View::visibleRange(const Range& data) const {
    return {range.lo, showsAbove() ? std::max(range.hi, data.hi) : range.hi};
}

SetView lookAs(const View& view) {
    return {view.camera,       view.mode,     view.range,   view.sculptureView, view.transferFunction,
            view.pasted,       view.sampling, view.shadows, view.hidesAbove,    view.surfaceSmoothing,
            view.tintsSegments};
}

const char* name(const Operation& operation) { return kOperationNames[operation.index()]; }

bool cuts(const Operation& operation) {
    return std::holds_alternative<Peel>(operation) || std::holds_alternative<Drill>(operation) ||
           std::holds_alternative<Laser>(operation) || std::holds_alternative<Sweep>(operation) ||
           std::holds_alternative<Scissors>(operation) || std::holds_alternative<Clip>(operation) ||
           std::holds_alternative<KeepConnected>(operation) || std::holds_alternative<CutSegment>(operation);
}

bool isEdit(const Operation& operation) {
    return !isOutput(operation) && !std::holds_alternative<SetView>(operation);
}

bool isOutput(const Operation& operation) {
    return std::holds_alternative<SavePicture>(operation) || std::holds_alternative<SaveLabels>(operation) ||
           std::holds_alternative<SaveSculpture>(operation);
}

} // namespace vs::studio
