// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tool.h"

namespace vs::desktop {

class StudioController;

// Turns the volume with the left button. Turning, moving and zooming are also there for the other buttons and
// the wheel whatever tool is chosen: that is turn(), pan(), zoom() and reset().
class CameraTool : public Tool {
    Q_OBJECT

public:
    explicit CameraTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "camera"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override { isDragging_ = false; }
    [[nodiscard]] bool isBusy() const override { return isDragging_; }

    // By a movement in logical pixels.
    void turn(QPointF delta);
    void pan(QPointF delta);
    // By a factor; the place under `anchor` (logical pixels of the view) stays there.
    void zoom(double factor, QPointF anchor);
    void reset();

private:
    StudioController& studio_;
    QPointF last_;
    bool isDragging_ = false;
};

} // namespace vs::desktop
