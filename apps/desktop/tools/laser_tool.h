// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/pen_tool.h"

#include <QTimer>

namespace vs::desktop {

// Burns down from the surface along its own normal. The mask that follows the pen is shown as it lies on the
// surface.
class LaserTool : public PenTool {
    Q_OBJECT

public:
    explicit LaserTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "laser"; }
    void press(const Pen& pen) override;
    void hover(const Pen& pen) override;

protected:
    [[nodiscard]] Words words() const override;
    [[nodiscard]] studio::Operation operation(const studio::PenCut& cut) const override;
    [[nodiscard]] QPainterPath mask() const override;

private:
    void lay();

    QTimer timer_;
    QPainterPath lying_; // empty: nothing is under the pen
    QPointF lyingAt_;    // where the pen was then
};

} // namespace vs::desktop
