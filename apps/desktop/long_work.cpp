// SPDX-License-Identifier: Apache-2.0
#include "long_work.h"

#include "gl_host.h"
#include "watched_application.h"

#include "base/progress.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QWidget>

namespace vs::desktop {

namespace {

constexpr int kMomentMs = 50;  // nobody notices
constexpr int kLastsMs = 400;  // from then on it is shown and can be given up
constexpr int kAnswerMs = 20;  // between looks at what the window wants

// Releases end what began before.
bool isInput(QEvent::Type type) {
    switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::NativeGesture:
    case QEvent::ContextMenu:
    case QEvent::KeyPress:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::DragEnter:
    case QEvent::DragMove:
    case QEvent::Drop:
    case QEvent::Close:
        return true;
    default:
        return false;
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

void LongWork::run(const std::function<void()>& work) {
    if (isRunning_) { // asked for by something that the window did meanwhile
        host_.makeCurrent();
        work();
        return;
    }
    isRunning_ = true;
    isGivenUp_ = false;
    thousandths_ = -1;
    failure_ = nullptr;
    host_.handOverTo(thread_);
    QMetaObject::invokeMethod(&runner_, [this, &work] { this->work(work); }, Qt::QueuedConnection);
    if (!done_.tryAcquire(1, kMomentMs)) {
        answerMeanwhile();
    }
    isRunning_ = false;
    host_.makeCurrent();
    if (failure_) {
        std::rethrow_exception(failure_);
    }
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
        failure_ = std::current_exception();
    }
    host_.handOverTo(*this->thread());
    done_.release();
}

void LongWork::answerMeanwhile() {
    const WatchedApplication::Answering answering;
    QElapsedTimer since;
    since.start();
    bool isShown = false;
    while (!done_.tryAcquire(1, kAnswerMs)) {
        QCoreApplication::processEvents(isShown ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents);
        if (!isShown && since.elapsed() > kLastsMs - kMomentMs) {
            isShown = true;
            qApp->installEventFilter(this);
        }
        if (isShown) {
            emit lasts(std::min<int>(thousandths_, 999));
        }
    }
    if (isShown) {
        // What was pressed while nothing could be done is not for what comes after.
        QCoreApplication::processEvents();
        qApp->removeEventFilter(this);
        emit lasts(1000);
    }
}

bool LongWork::eventFilter(QObject* watched, QEvent* event) {
    if (!isInput(event->type())) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        giveUp();
    }
    const bool isForGivingUp = watched->isWidgetType() && watched->objectName() == "giveUp";
    // Windows pass what the pointer does on to the widget under it.
    const bool isPassedOn = watched->isWindowType() && event->type() != QEvent::Close;
    if (isForGivingUp || isPassedOn) {
        return QObject::eventFilter(watched, event);
    }
    event->ignore();
    return true;
}

} // namespace vs::desktop
