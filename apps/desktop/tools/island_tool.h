// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/click_tool.h"

namespace vs::desktop {

// One click on a connected part of the segment at work drops it or, with the sign reversed, keeps it alone.
class IslandTool : public ClickTool {
    Q_OBJECT

public:
    using ClickTool::ClickTool;

    [[nodiscard]] QString name() const override { return "island"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return keeps_; }
    void setReversed(bool reversed) override;

protected:
    void click(glm::dvec2 pixel) override;
    [[nodiscard]] Overlay::Tint tint() const override {
        return keeps_ ? Overlay::Tint::Idle : Overlay::Tint::Cutting;
    }

private:
    bool keeps_ = false;
};

} // namespace vs::desktop
