// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractNativeEventFilter>
#include <QObject>
#include <QTimer>
#include <QWindow>

namespace vs::desktop {

class StudioController;

// Tells scripts when the program has answered what they did with keys and pointer. Behind its input a script
// sends a key, the fence, to window(), which nobody sees. The X server and Qt keep keys and buttons in order,
// so the fence arrives when all input before it has been taken from the queue. It is passed when, besides,
// the handlers of that input have returned (or show a dialog), long work that they began is over or shows
// that it lasts, the next picture is shown and the panels have been told, and what the program asked of the
// X server meanwhile (to show a dialog, to give it the keyboard) is done. On X11 only.
class InputFence : public QObject, public QAbstractNativeEventFilter {
    Q_OBJECT

public:
    explicit InputFence(StudioController& studio);
    ~InputFence() override;

    [[nodiscard]] WId window() const { return window_.winId(); }
    // How many fences the program has passed.
    [[nodiscard]] int passed() const { return passed_; }

    bool nativeEventFilter(const QByteArray& kind, void* message, qintptr* result) override;

signals:
    void isPassed();

private:
    void goRound();
    void poll();

    StudioController& studio_;
    QWindow window_; // never shown
    QTimer timer_;
    int arrived_ = 0;
    int passed_ = 0;
    int titles_ = 0;
    int rounds_ = 0;         // since the last fence arrived
    double deliveredMs_ = 0; // Timer::now() when all input before the fence was delivered
};

} // namespace vs::desktop
