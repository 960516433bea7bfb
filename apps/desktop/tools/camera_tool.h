// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

#include "base/math.h"

namespace vs::desktop {

// Turns the volume with the left button. Turning, moving and zooming are also there for the other buttons,
// the wheel, fingers and keys whatever tool is chosen: that is turn(), pan(), zoom(), roll() and reset().
class CameraTool : public StudioTool {
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

    // Turns the volume by a movement in logical pixels.
    void turn(QPointF delta);
    void pan(QPointF delta);
    // Zooms by a factor; the place under `anchor` (logical pixels of the view) stays there.
    void zoom(double factor, QPointF anchor);
    // Rolls about the line of sight, clockwise; the place under `anchor` stays there.
    void roll(double degrees, QPointF anchor);
    void reset();

private:
    // How far a place of the view (logical pixels) is from its centre to the right and up, at the depth that
    // is looked at.
    [[nodiscard]] glm::dvec2 millimetresFromCentre(QPointF place) const;

    QPointF last_;
    bool isDragging_ = false;
};

} // namespace vs::desktop
