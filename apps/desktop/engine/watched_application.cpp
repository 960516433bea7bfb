// SPDX-License-Identifier: Apache-2.0
#include "engine/watched_application.h"

#include "base/timer.h"

#include <QThread>

#include <ctime>

namespace vs::desktop {

namespace {

double millisecondsOf(clockid_t clock) {
    std::timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

} // namespace

WatchedApplication::Moment WatchedApplication::now() {
    return {Timer::now(), millisecondsOf(CLOCK_THREAD_CPUTIME_ID), millisecondsOf(CLOCK_PROCESS_CPUTIME_ID)};
}

WatchedApplication::Answering::Answering() {
    if (auto* application = dynamic_cast<WatchedApplication*>(qApp)) {
        ++application->answering_;
        application->tell();
    }
}

WatchedApplication::Answering::~Answering() {
    if (auto* application = dynamic_cast<WatchedApplication*>(qApp)) {
        --application->answering_;
        if (!application->deliveries_.empty()) {
            application->deliveries_.back().since = now();
        }
    }
}

void WatchedApplication::tell() const {
    if (tell_ && !deliveries_.empty()) {
        const Delivery& last = deliveries_.back();
        const Moment end = now();
        tell_({last.since.ms, end.ms - last.since.ms, end.threadMs - last.since.threadMs,
               end.programMs - last.since.programMs, last.receiver, last.type});
    }
}

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
    const bool isOurs = QThread::currentThread() == thread();
    const int level = isOurs ? QThread::currentThread()->loopLevel() + answering_ : -1;
    const bool isSentByAnother = !deliveries_.empty() && deliveries_.back().loopLevel == level;
    if (!tell_ || !isOurs || isSentByAnother) {
        return QApplication::notify(receiver, event);
    }
    // Neither event nor receiver need to outlive it.
    const QString name = QString("%1 %2").arg(receiver->metaObject()->className(), receiver->objectName());
    deliveries_.push_back({level, now(), name, event->type()});
    const bool isTaken = QApplication::notify(receiver, event);
    tell();
    deliveries_.pop_back();
    if (!deliveries_.empty()) {
        deliveries_.back().since = now(); // the enclosing loop was answering meanwhile
    }
    return isTaken;
}

} // namespace vs::desktop
