// SPDX-License-Identifier: Apache-2.0
#include "cut_tool.h"

#include "studio_controller.h"

namespace vs::desktop {

CutTool::CutTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

void CutTool::setRestores(bool restores) {
    if (restores != restores_) {
        restores_ = restores;
        tell();
    }
}

void CutTool::setRadius(int steps) {
    if (steps != radius_) {
        radius_ = steps;
        tell();
    }
}

void CutTool::tell() {
    emit settingsChanged();
    emit overlayChanged();
}

} // namespace vs::desktop
