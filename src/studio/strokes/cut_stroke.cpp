// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cut_stroke.h"

#include <utility>

namespace vs::studio {

sculpt::SculptureDelta CutStroke::finish() {
    sculpt::SculptureDelta delta(backup_.finish());
    if (sculpt::FineSculpture* finer = cutter_->sculpture->finer()) {
        delta.finer = cutsInScene_ ? cutter_->sculpture->cutFiner(delta)
                                   : finer->since(std::exchange(originals_, {}));
    }
    if (delta.isEmpty()) {
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
    return delta;
}

void CutStroke::takeBack(sculpt::SculptureDelta& delta) {
    cutter_->sculpture->swap(delta);
    cutter_->sculpture->contentIsAsAt(contentVersion_);
}

void CutStroke::discard() {
    if (!originals_.empty()) {
        cutter_->sculpture->finer()->takeBack(std::exchange(originals_, {}));
    }
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
}

} // namespace vs::studio
