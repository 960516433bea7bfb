// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"

#include <QObject>
#include <QPointer>

namespace vs::desktop {

class Hand;
class Tool;

// Knows where the tablet's pen is: watches the program's tablet events before any widget has them. While the
// pen's eraser end is near, the tool is turned round (as by R); while the pen is near, fingers and the palm
// of the hand that holds it mean nothing.
class PenWatch : public QObject {
    Q_OBJECT

public:
    // Watches for as long as it lives. Needs a QApplication.
    explicit PenWatch(Hand& hand, QObject* parent = nullptr);

    // Down, or hovering within the tablet's reach. Tablets that never say that the pen has left count as left
    // after kForgottenMs without a report.
    [[nodiscard]] bool isPenNear() const;
    static constexpr double kForgottenMs = 1500;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void see(bool isEraser);
    void turn(Tool* tool);

    Hand& hand_;
    QPointer<Tool> turned_; // by the eraser end
    bool isNear_ = false;
    bool isDown_ = false;
    Timer sinceReport_;
};

} // namespace vs::desktop
