// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/click_tool.h"

namespace vs::desktop {

// One click on an object cuts everything visible that is not connected to it.
class KeepTool : public ClickTool {
    Q_OBJECT

public:
    using ClickTool::ClickTool;

    [[nodiscard]] QString name() const override { return "keep"; }
    [[nodiscard]] QString hint() const override;

    // Whether voxels that touch at an edge or a corner are connected too, or only those that share a face.
    [[nodiscard]] bool joinsCorners() const { return joinsCorners_; }
    void setJoinsCorners(bool on) { joinsCorners_ = on; }

protected:
    void click(glm::dvec2 pixel) override;

private:
    bool joinsCorners_ = true;
};

} // namespace vs::desktop
