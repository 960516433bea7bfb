// SPDX-License-Identifier: Apache-2.0
#include "testing/input_fence.h"

#include "engine/long_work.h"
#include "model/studio/studio_controller.h"

#include "base/timer.h"

#include <QGuiApplication>

#include <xcb/xproto.h>

namespace vs::desktop {

namespace {

constexpr int kPollMs = 2;
// The first ends with the input delivered, the second with the picture shown. A dialog that came with it is
// mapped in the third, gets the keyboard in the fourth and hears of it in the fifth.
constexpr int kRounds = 5;

} // namespace

InputFence::InputFence(StudioController& studio) : studio_(studio) {
    timer_.setSingleShot(true);
    timer_.setProperty(LongWork::kRunsMeanwhile, true);
    connect(&timer_, &QTimer::timeout, this, &InputFence::poll);
    window_.create();
    qApp->installNativeEventFilter(this);
}

InputFence::~InputFence() { qApp->removeNativeEventFilter(this); }

bool InputFence::nativeEventFilter(const QByteArray& kind, void* message, qintptr*) {
    if (kind != "xcb_generic_event_t") {
        return false;
    }
    constexpr int kSentByAnother = 0x80; // set in the type of what is no real key
    const auto& event = *static_cast<const xcb_generic_event_t*>(message);
    switch (event.response_type & ~kSentByAnother) {
    case XCB_KEY_PRESS: {
        const auto& key = *static_cast<const xcb_key_press_event_t*>(message);
        if (key.event != window_.winId()) {
            return false;
        }
        ++arrived_;
        rounds_ = 0;
        goRound();
        return true;
    }
    case XCB_PROPERTY_NOTIFY: {
        const auto& property = *static_cast<const xcb_property_notify_event_t*>(message);
        if (property.window == window_.winId() && property.atom == XCB_ATOM_WM_NAME && passed_ < arrived_) {
            timer_.start(0); // behind all that has been queued
        }
        return false;
    }
    default:
        return false;
    }
}

// The X server answers in order: when it tells of the new title, all that was asked of it before is done, and
// Qt has heard of it.
void InputFence::goRound() { window_.setTitle(QString::number(++titles_)); }

void InputFence::poll() {
    const bool isFree = !studio_.host().isAway() || studio_.host().isLasting();
    const bool isSeen = rounds_ == 0 || studio_.answeredMs() >= deliveredMs_ || studio_.host().isLoading() ||
                        studio_.host().isLasting();
    if (!isFree || !isSeen) {
        timer_.start(kPollMs);
        return;
    }
    if (rounds_ == 0) {
        deliveredMs_ = Timer::now();
        studio_.host().workSoon();
    }
    if (++rounds_ < kRounds) {
        goRound();
    } else {
        passed_ = arrived_;
        emit isPassed();
    }
}

} // namespace vs::desktop
