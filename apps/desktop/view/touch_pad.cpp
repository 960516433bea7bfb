// SPDX-License-Identifier: Apache-2.0
#include "view/touch_pad.h"

#include "model/hand/pen_watch.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "view/slice_canvas.h"
#include "view/view_widget.h"

#include <QTouchEvent>

#include <cmath>
#include <memory>
#include <utility>

namespace vs::desktop {

namespace {
constexpr double kTapPixels = 8;       // a finger that moves less has tapped
constexpr double kPixelsPerSlice = 12; // of a finger's way up or down
} // namespace

TouchPad::TouchPad(QWidget& widget, const PenWatch& pen, std::function<void(const FingerMotion&)> moved,
                   std::function<void(QPointF)> tapped)
    : QObject(&widget), pen_(pen), moved_(std::move(moved)), tapped_(std::move(tapped)) {
    widget.setAttribute(Qt::WA_AcceptTouchEvents);
    widget.installEventFilter(this);
}

bool TouchPad::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::TouchBegin:
        isRefused_ = false;
        [[fallthrough]];
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
        follow(*static_cast<QTouchEvent*>(event));
        event->accept(); // or Qt would make a mouse of the first finger
        return true;
    case QEvent::TouchCancel:
        tracker_.forget();
        isTap_ = false;
        return true;
    default:
        return QObject::eventFilter(watched, event);
    }
}

void TouchPad::follow(const QTouchEvent& touch) {
    isRefused_ = isRefused_ || pen_.isPenNear();
    if (isRefused_) {
        tracker_.forget();
        isTap_ = false;
        return;
    }
    const QPointF first = touch.points().constFirst().position();
    if (touch.type() == QEvent::TouchBegin) {
        began_ = first;
        isTap_ = true;
    }
    const QPointF way = first - began_;
    isTap_ = isTap_ && touch.points().size() == 1 && std::hypot(way.x(), way.y()) < kTapPixels;
    const FingerMotion motion = tracker_.follow(touch.points());
    if (motion.fingers > 0) {
        moved_(motion);
    }
    if (touch.type() == QEvent::TouchEnd && isTap_ && tapped_) {
        tapped_(first);
    }
}

void steerByFingers(ViewWidget& view, StudioController& studio, const PenWatch& pen) {
    new TouchPad(view, pen, [&studio, &camera = studio.camera()](const FingerMotion& motion) {
        if (studio.host().document() == nullptr || studio.hand().tool().isSketching()) {
            return; // the picture holds still under a stroke
        }
        if (motion.fingers == 1) {
            camera.turn(motion.moved);
            return;
        }
        const QPointF to = motion.from + motion.moved;
        camera.pan(motion.moved);
        camera.zoom(motion.scale, to);
        camera.roll(motion.degrees, to);
    });
}

void steerByFingers(SliceCanvas& canvas, StudioController& studio, const PenWatch& pen) {
    SliceController& slices = studio.slices();
    const auto left = std::make_shared<double>(0); // of the finger's way, not used for a slice yet
    const auto move = [&slices, &canvas, left](const FingerMotion& motion) {
        if (!slices.hasVolume()) {
            return;
        }
        if (motion.fingers == 1) {
            *left += -motion.moved.y() / kPixelsPerSlice;
            const int whole = int(std::trunc(*left));
            *left -= whole;
            slices.scroll(canvas.kind(), whole);
            return;
        }
        const QPointF to = motion.from + motion.moved;
        slices.pan(canvas.kind(), canvas.placeAt(motion.from) - canvas.placeAt(to));
        slices.zoom(canvas.kind(), motion.scale, canvas.placeAt(to));
    };
    new TouchPad(canvas, pen, move, [&slices, &canvas](QPointF place) {
        if (slices.hasVolume()) {
            const auto slice = slices.geometry(canvas.kind());
            slices.setCrosshair(slice.voxelAt(canvas.placeAt(place), slices.crosshair()[slice.axis()]));
        }
    });
}

} // namespace vs::desktop
