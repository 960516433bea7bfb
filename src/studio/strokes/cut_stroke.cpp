// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/cut_stroke.h"

namespace vs::studio {

sculpt::BrickDelta CutStroke::finish() {
    sculpt::BrickDelta delta = backup_.finish();
    if (delta.isEmpty()) {
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
    return delta;
}

void CutStroke::takeBack(sculpt::BrickDelta& delta) {
    cutter_->sculpture->swap(delta);
    cutter_->sculpture->contentIsAsAt(contentVersion_);
}

void CutStroke::discard() {
    if (!backup_.isEmpty()) {
        cutter_->sculpture->refresh(backup_.restore());
        cutter_->sculpture->contentIsAsAt(contentVersion_);
    }
}

} // namespace vs::studio
