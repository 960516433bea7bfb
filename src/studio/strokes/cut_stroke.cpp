// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cut_stroke.h"

#include <utility>

namespace vs::studio {

sculpt::SculptureDelta CutStroke::finish() {
    const sculpt::FineSculpture* finer = cutter_->sculpture->finer();
    // What needs memory comes first: when it throws, everything is as it was.
    sculpt::FineDelta finest = finer != nullptr ? finer->since(originals_) : sculpt::FineDelta();
    sculpt::SculptureDelta delta(backup_.finish(), std::move(finest));
    originals_.clear();
    if (cutsInScene_) {
        cutter_->sculpture->cutFiner(delta);
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
        cutter_->sculpture->finer()->takeBack(originals_);
        originals_.clear();
    }
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
}

} // namespace vs::studio
