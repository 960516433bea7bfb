// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QThread>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <vector>

namespace vs::desktop {

class GlHost;

// Runs work on the document on a thread of its own, which has the engine's context meanwhile, so that the
// window goes on painting itself. For whoever calls it is a call like any other, but one during which the
// window paints, and nothing else happens in it: input and timers wait (but those whose property
// kRunsMeanwhile is set). A drag that was under way goes on afterwards where the pointer is by then. Files
// that are dragged in from another program are answered at once; whoever takes them waits for the end.
// Whoever makes the engine's context current waits for the end.
class LongWork : public QObject {
    Q_OBJECT

public:
    static constexpr const char* kRunsMeanwhile = "runsMeanwhile";

    explicit LongWork(GlHost& host);
    ~LongWork() override;

    // What becomes of input that comes while work lasts.
    enum class Input {
        Waits,   // until it is done
        GivesUp, // Esc or the button named "giveUp" do; all else is dropped
    };
    // Runs the work; returns when it is done and throws what it throws. Work may report how far it is
    // (base/progress.h).
    void run(const std::function<void()>& work, Input input = Input::Waits);
    [[nodiscard]] bool isRunning() const { return isRunning_; }
    // Whether work is under way that lasts and can be given up: all other input is dropped meanwhile.
    [[nodiscard]] bool isShown() const { return isShown_; }
    // Asks the work to stop: it ends with GivenUp the next time that it reports how far it is.
    void giveUp() { isGivenUp_ = true; }

signals:
    // Work lasts and can be given up: tells how far it is, in thousandths, below zero when nobody knows, and
    // once 1000 when it has ended.
    void lasts(int thousandths);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void work(const std::function<void()>& work);
    void answerUntil(const std::future<void>& done, Input input);
    [[nodiscard]] bool isDragUnderWay(const QEvent& event) const;
    void hold(QObject* receiver, const QEvent& event);
    void deliverHeld();

    GlHost& host_;
    QThread thread_;
    QObject runner_; // lives on the thread
    bool isRunning_ = false;
    bool isShown_ = false;
    // An input event that goes on with, or ends, what began before the work; it is delivered afterwards.
    struct Held {
        QPointer<QObject> receiver;
        std::unique_ptr<QEvent> event;
    };
    std::vector<Held> held_;
    bool isPressedMeanwhile_ = false; // moves from then on belong to a press that was dropped
    std::atomic<bool> isGivenUp_ = false;
    std::atomic<int> thousandths_ = -1;
};

} // namespace vs::desktop
