// SPDX-License-Identifier: Apache-2.0
#include "tools/keep_tool.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

QString KeepTool::hint() const {
    if (isBusy()) {
        return tr("Let go to cut away all that is not connected to what is under the ring. Esc changes "
                  "nothing.");
    }
    return tr("Click the object to keep: all that is visible and not connected to it is cut away.");
}

void KeepTool::click(glm::dvec2 pixel) {
    studio::KeepConnected keep;
    keep.pixel = pixel;
    keep.connectivity = joinsCorners_ ? 26 : 6;
    keep.canvas = studio_.view().canvas();
    studio_.editor().apply(keep);
}

} // namespace vs::desktop
