// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSemaphore>
#include <QThread>

#include <atomic>
#include <exception>
#include <functional>

namespace vs::desktop {

class GlHost;

// Runs work on the document on a thread of its own, which has the engine's context meanwhile, so that the
// window goes on painting itself. For whoever calls it is a call like any other, but one during which
// events are handled: everything but input, which waits; and when it lasts, all input but what gives it up is
// dropped. Nothing may touch the document then; who makes the context current waits for the end.
class LongWork : public QObject {
    Q_OBJECT

public:
    explicit LongWork(GlHost& host);
    ~LongWork() override;

    // Returns when it is done; throws what it throws. Work may report how far it is (base/progress.h).
    void run(const std::function<void()>& work);
    [[nodiscard]] bool isRunning() const { return isRunning_; }
    // Work that asks ends with GivenUp.
    void giveUp() { isGivenUp_ = true; }

signals:
    // It takes more than a moment; how far it is, in thousandths, below zero when nobody knows. Once with
    // 1000 when it has ended.
    void lasts(int thousandths);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void work(const std::function<void()>& work);
    void answerMeanwhile();

    GlHost& host_;
    QThread thread_;
    QObject runner_; // lives on the thread
    bool isRunning_ = false;
    QSemaphore done_;
    std::exception_ptr failure_;
    std::atomic<bool> isGivenUp_ = false;
    std::atomic<int> thousandths_ = -1;
};

} // namespace vs::desktop
