// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hint_walk.h"

namespace vs::desktop {

// Go through every state of the tools that sketch, with every shape; and of those that are clicked with, act
// on a segment or move a part. A volume is opened first.
void forEachSketchHint(StudioWindow& window, const HintWalk::Look& look);
void forEachClickHint(StudioWindow& window, const HintWalk::Look& look);

} // namespace vs::desktop
