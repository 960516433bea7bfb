// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

namespace vs::desktop {

class StudioController;

// A tool that works on the studio, which owns it.
class StudioTool : public Tool {
    Q_OBJECT

public:
    explicit StudioTool(StudioController& studio);

protected:
    StudioController& studio_;
};

} // namespace vs::desktop
