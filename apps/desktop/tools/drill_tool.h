// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/pen_tool.h"

namespace vs::desktop {

// Drills along the view, through the mask that follows the pen, or along the pen's tilt.
class DrillTool : public PenTool {
    Q_OBJECT

public:
    explicit DrillTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "drill"; }

    // Whether the direction is that of a tablet's pen instead of the view's.
    [[nodiscard]] bool followsTilt() const { return followsTilt_; }
    void setFollowsTilt(bool on);

protected:
    [[nodiscard]] Words words() const override;
    [[nodiscard]] studio::Operation operation(const studio::PenCut& cut) const override;

private:
    bool followsTilt_ = false;
};

} // namespace vs::desktop
