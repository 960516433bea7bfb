// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"

#include <optional>

namespace vs::desktop {

class StudioController;

// One click on an object cuts everything visible that is not connected to it.
class KeepTool : public Tool {
    Q_OBJECT

public:
    explicit KeepTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "keep"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }
    void press(const Pen& pen) override;
    void move(const Pen&) override {}
    void release(const Pen& pen) override;
    void clear() override;
    [[nodiscard]] bool isBusy() const override { return pressed_.has_value(); }

    // Whether voxels that touch at an edge or a corner are connected too, or only those that share a face.
    [[nodiscard]] bool joinsCorners() const { return joinsCorners_; }
    void setJoinsCorners(bool on) { joinsCorners_ = on; }

private:
    StudioController& studio_;
    bool joinsCorners_ = true;
    std::optional<QPointF> pressed_;
};

} // namespace vs::desktop
