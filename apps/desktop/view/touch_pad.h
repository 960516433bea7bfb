// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/finger_motion.h"

#include <QObject>

#include <functional>

class QTouchEvent;
class QWidget;

namespace vs::desktop {

class PenWatch;
class SliceCanvas;
class StudioController;
class ViewWidget;

// Fingers on a widget always look around, whatever the tool: only pen and mouse draw. Takes the widget's
// touches, but for those of a hand whose pen is near.
class TouchPad : public QObject {
    Q_OBJECT

public:
    // Calls `moved` for each motion, `tapped` when one finger came and went without moving.
    TouchPad(QWidget& widget, const PenWatch& pen, std::function<void(const FingerMotion&)> moved,
             std::function<void(QPointF)> tapped = {});

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow(const QTouchEvent& touch);

    const PenWatch& pen_;
    std::function<void(const FingerMotion&)> moved_;
    std::function<void(QPointF)> tapped_;
    FingerTracker tracker_;
    QPointF began_;
    bool isTap_ = false;
    bool isRefused_ = false; // the pen was near: nothing until all fingers have left
};

// One finger turns the volume; two move it, zoom by their distance and roll by their angle, so that what was
// under them stays under them. The widget owns what is made.
void steerByFingers(ViewWidget& view, StudioController& studio, const PenWatch& pen);

// One finger goes from slice to slice, a tap leads the crosshair, two fingers move and zoom.
void steerByFingers(SliceCanvas& canvas, StudioController& studio, const PenWatch& pen);

} // namespace vs::desktop
