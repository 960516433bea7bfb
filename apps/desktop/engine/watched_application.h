// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

#include <functional>
#include <vector>

namespace vs::desktop {

// A QApplication that knows how long each event kept the window from turning to the next one.
class WatchedApplication : public QApplication {
public:
    using QApplication::QApplication;

    // How long an event that a loop delivered took; what loops within it delivered counts for itself. Times
    // of Timer::now(), and how much processor time the window's thread and the whole program had meanwhile,
    // which other programs on the machine do not lengthen; names of the receiver and its class, and the
    // event's type (QEvent::Type).
    struct Busy {
        double beganMs = 0;
        double milliseconds = 0;
        double threadMs = 0;
        double programMs = 0;
        QString receiver;
        int type = 0;
    };
    void watch(std::function<void(const Busy&)> tell) { tell_ = std::move(tell); }

    // While it lives, the event that is being delivered lets others be delivered (processEvents()): those
    // count for themselves, and waiting for them does not count at all.
    class Answering {
    public:
        Answering();
        ~Answering();
        Answering(const Answering&) = delete;
        Answering& operator=(const Answering&) = delete;
    };

    bool notify(QObject* receiver, QEvent* event) override;

private:
    // A moment, and how much processor time the window's thread and the whole program had by then.
    struct Moment {
        double ms = 0;
        double threadMs = 0;
        double programMs = 0;
    };
    static Moment now();

    // The event that a loop of some depth is delivering.
    struct Delivery {
        int loopLevel = 0;
        Moment since;
        QString receiver;
        int type = 0;
    };

    void tell() const;

    std::function<void(const Busy&)> tell_;
    std::vector<Delivery> deliveries_;
    int answering_ = 0;
};

} // namespace vs::desktop
