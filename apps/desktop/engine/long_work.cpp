// SPDX-License-Identifier: Apache-2.0
#include "engine/long_work.h"

#include "engine/gl_host.h"
#include "engine/watched_application.h"

#include "base/log.h"
#include "base/progress.h"
#include "base/timer.h"

#include <QAbstractEventDispatcher>
#include <QKeyEvent>
#include <QOpenGLContext>
#include <QTimer>

namespace vs::desktop {

namespace {

constexpr auto kMoment = std::chrono::milliseconds(50); // nobody notices
constexpr auto kAnswer = std::chrono::milliseconds(20); // between looks at what the window wants
constexpr double kLastsMs = 350; // after a moment: from then on it is shown and can be given up

bool isRelease(QEvent::Type type) {
    return type == QEvent::MouseButtonRelease || type == QEvent::TabletRelease || type == QEvent::TouchEnd ||
           type == QEvent::KeyRelease;
}

bool isPress(QEvent::Type type) {
    return type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick ||
           type == QEvent::TabletPress || type == QEvent::TouchBegin;
}

// Without what is dragged in from other programs: those wait for an answer.
bool isInput(QEvent::Type type) {
    switch (type) {
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TabletMove:
    case QEvent::TouchUpdate:
    case QEvent::NativeGesture:
    case QEvent::ContextMenu:
    case QEvent::KeyPress:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::Close:
        return true;
    default:
        return isPress(type) || isRelease(type);
    }
}

} // namespace

LongWork::LongWork(GlHost& host) : host_(host) {
    thread_.setObjectName("document");
    runner_.moveToThread(&thread_);
    thread_.start();
}

LongWork::~LongWork() {
    thread_.quit();
    thread_.wait();
}

void LongWork::run(const std::function<void()>& work, Input input) {
    // Asked for by something that the window did meanwhile; or the driver knows one thread only.
    if (isRunning_ || !QOpenGLContext::supportsThreadedOpenGL()) {
        host_.makeCurrent();
        work();
        return;
    }
    isRunning_ = true;
    isGivenUp_ = false;
    isPressedMeanwhile_ = false;
    thousandths_ = -1;
    const auto task = std::make_shared<std::packaged_task<void()>>([this, &work] { this->work(work); });
    std::future<void> done = task->get_future();
    host_.handOverTo(thread_);
    QMetaObject::invokeMethod(
        &runner_, [task] { (*task)(); }, Qt::QueuedConnection);
    if (done.wait_for(kMoment) != std::future_status::ready) {
        answerUntil(done, input);
    }
    isRunning_ = false;
    host_.makeCurrent(); // back here
    done.get();
}

// On the thread.
void LongWork::work(const std::function<void()>& work) {
    const ProgressListener listener([this](std::optional<double> share) {
        thousandths_ = share ? int(1000 * *share) : -1;
        return !isGivenUp_;
    });
    try {
        host_.makeCurrent();
        work();
    } catch (...) {
        host_.handOverTo(*thread());
        throw;
    }
    host_.handOverTo(*thread());
}

void LongWork::answerUntil(const std::future<void>& done, Input input) {
    const WatchedApplication::Answering answering;
    const Timer since;
    qApp->installEventFilter(this);
    while (done.wait_for(kAnswer) != std::future_status::ready) {
        try {
            QCoreApplication::processEvents(isShown_ ? QEventLoop::AllEvents
                                                     : QEventLoop::ExcludeUserInputEvents);
        } catch (const std::exception& e) { // a fault in a widget; the work goes on
            logNotice(e.what());
        }
        isShown_ = input == Input::GivesUp && since.milliseconds() > kLastsMs;
        if (isShown_) {
            emit lasts(std::min<int>(thousandths_, 999));
        }
    }
    if (isShown_) {
        // What was pressed while nothing could be done is not for what comes after.
        QCoreApplication::processEvents();
        isShown_ = false;
        emit lasts(1000);
    }
    qApp->removeEventFilter(this);
    deliverHeld();
}

bool LongWork::isDragUnderWay(const QEvent& event) const {
    switch (event.type()) {
    case QEvent::MouseMove:
    case QEvent::TabletMove:
        return !isPressedMeanwhile_ && static_cast<const QSinglePointEvent&>(event).buttons() != Qt::NoButton;
    case QEvent::TouchUpdate:
        return !isPressedMeanwhile_;
    default:
        return false;
    }
}

// Of several moves the last counts: nothing was shown of the others.
void LongWork::hold(QObject* receiver, const QEvent& event) {
    const bool isFurther =
        !held_.empty() && held_.back().receiver == receiver && held_.back().event->type() == event.type();
    if (isFurther && !isRelease(event.type())) {
        held_.pop_back();
    }
    held_.push_back({receiver, std::unique_ptr<QEvent>(event.clone())});
}

// Whoever gave up does not want the rest of the drag either, only its end.
void LongWork::deliverHeld() {
    for (Held& held : std::exchange(held_, {})) {
        if (held.receiver && (isRelease(held.event->type()) || !isGivenUp_)) {
            QCoreApplication::postEvent(held.receiver, held.event.release());
        }
    }
    // What was posted while the work ended would wait for the next input.
    QCoreApplication::eventDispatcher()->wakeUp();
}

bool LongWork::eventFilter(QObject* watched, QEvent* event) {
    // A timer whose event nobody gets fires again.
    if (event->type() == QEvent::Timer && qobject_cast<QTimer*>(watched) != nullptr) {
        return !watched->property(kRunsMeanwhile).toBool();
    }
    // A key that is a shortcut is offered first, and comes no more once that is taken.
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        giveUp();
    }
    // Windows pass on what the pointer does to the widget under it.
    const bool isPassedOn = watched->isWindowType() && event->type() != QEvent::Close;
    const bool isToGiveUp = watched->objectName() == "giveUp";
    if (isPassedOn || isToGiveUp || !isInput(event->type())) {
        return QObject::eventFilter(watched, event);
    }
    isPressedMeanwhile_ = isPressedMeanwhile_ || isPress(event->type());
    if (isRelease(event->type()) || isDragUnderWay(*event)) {
        hold(watched, *event);
    }
    event->ignore();
    return true;
}

} // namespace vs::desktop
