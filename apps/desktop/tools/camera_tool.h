// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

namespace vs::desktop {

// Turns the volume with the left button; along the view's rim it rolls the picture. The other buttons, the
// wheel, fingers and keys look around whatever tool is chosen (CameraMotion).
class CameraTool : public StudioTool {
    Q_OBJECT

public:
    // What dragging in the middle of the picture does; along the rim it rolls.
    enum class Use { Turn, Move, Zoom };

    explicit CameraTool(StudioController& studio);

    [[nodiscard]] Use use() const { return use_; }
    void setUse(Use use);

    [[nodiscard]] QString name() const override { return "camera"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void leave() override;
    void clear() override;
    [[nodiscard]] bool isBusy() const override { return drag_ != Drag::None; }

private:
    enum class Drag { None, Use, Roll };

    [[nodiscard]] bool isAtRim(QPointF place) const;
    void showRim(bool isShown);

    Use use_ = Use::Turn;
    QPointF pressed_;
    QPointF last_;
    Drag drag_ = Drag::None;
    bool isRimShown_ = false; // the pen is over it
};

} // namespace vs::desktop
