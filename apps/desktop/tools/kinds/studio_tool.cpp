// SPDX-License-Identifier: Apache-2.0
#include "tools/kinds/studio_tool.h"

#include "model/studio/studio_controller.h"

namespace vs::desktop {

StudioTool::StudioTool(StudioController& studio) : Tool(&studio), studio_(studio) {}

} // namespace vs::desktop
