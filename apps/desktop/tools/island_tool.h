// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

#include <optional>

namespace vs::desktop {

class StudioController;

// One click on a connected part of the segment at work drops it or, with the sign reversed, keeps it alone.
class IslandTool : public Tool {
    Q_OBJECT

public:
    explicit IslandTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "island"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }
    void press(const Pen& pen) override;
    void move(const Pen&) override {}
    void release(const Pen& pen) override;
    void clear() override;
    [[nodiscard]] bool isBusy() const override { return pressed_.has_value(); }
    [[nodiscard]] bool hasSign() const override { return true; }
    [[nodiscard]] bool isReversed() const override { return keeps_; }
    void setReversed(bool reversed) override;

private:
    StudioController& studio_;
    bool keeps_ = false;
    std::optional<QPointF> pressed_;
};

} // namespace vs::desktop
