// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

#include <glm/glm.hpp>

#include <optional>

namespace vs::desktop {

// A tool that does something to what is clicked. A ring marks the place while the button is down; letting go
// does it, Escape does not.
class ClickTool : public StudioTool {
    Q_OBJECT

public:
    using StudioTool::StudioTool;

    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }
    void press(const Pen& pen) override;
    void move(const Pen&) override {}
    void release(const Pen& pen) override;
    void clear() override;
    [[nodiscard]] bool isBusy() const override { return pressed_.has_value(); }

protected:
    // In the viewport's device pixels.
    virtual void click(glm::dvec2 pixel) = 0;
    // The ring's.
    [[nodiscard]] virtual Overlay::Tint tint() const { return Overlay::Tint::Idle; }

private:
    std::optional<QPointF> pressed_;
};

} // namespace vs::desktop
