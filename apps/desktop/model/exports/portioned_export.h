// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>

namespace vs::desktop {

class StudioController;

// Something that is written from the document in portions, so that the window answers meanwhile. No widgets.
class PortionedExport : public QObject {
    Q_OBJECT

public:
    explicit PortionedExport(StudioController& studio);

    virtual void cancel() = 0;
    [[nodiscard]] bool isRunning() const { return isRunning_; }

signals:
    void progressed(int done, int total);
    void finished(bool isDone, const QString& message);

protected:
    // From now on tick() is called, until end(). Each portion says when the next one comes.
    void start();
    void goOn(int afterMs = 0) { timer_.start(afterMs); }
    void end(bool isDone, const QString& message);
    virtual void tick() = 0;
    // It has ended: lets go of what it holds.
    virtual void letGo() = 0;
    // It is made from the document as it is now; whether that is another one since.
    void keepVersion();
    [[nodiscard]] bool hasChanged() const;

    StudioController& studio_;

private:
    bool isRunning_ = false;
    std::uint64_t version_ = 0;
    QTimer timer_;
};

} // namespace vs::desktop
