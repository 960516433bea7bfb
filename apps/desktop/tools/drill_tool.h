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
    // Whether it drills through all of the volume at full pressure, instead of down to the depth.
    [[nodiscard]] bool goesThrough() const { return goesThrough_; }
    void setGoesThrough(bool on);

protected:
    [[nodiscard]] double strokeDepth() const override;
    [[nodiscard]] Words words() const override;
    [[nodiscard]] studio::Operation operation(const studio::PenCut& cut) const override;

private:
    bool followsTilt_ = false;
    bool goesThrough_ = false;
};

} // namespace vs::desktop
