// SPDX-License-Identifier: Apache-2.0
// Input while the document is at work and nothing else can be done.
#include "engine/long_work.h"
#include "studio_window.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>

#include <atomic>
#include <utility>
#include <vector>

namespace vs::desktop {
namespace {

// Remembers what reaches it.
class Pad : public QWidget {
public:
    std::vector<std::pair<QEvent::Type, double>> got; // and where, along x

protected:
    bool event(QEvent* event) override {
        switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            got.emplace_back(event->type(), static_cast<QMouseEvent*>(event)->position().x());
            return true;
        default:
            return QWidget::event(event);
        }
    }
};

class LongWorkTest : public testing::Test {
protected:
    // What reaches the pad of what is sent to it while work lasts that can be given up.
    void send(const std::vector<std::pair<QEvent::Type, double>>& input, bool isGivenUp = false) {
        std::atomic<bool> isSent = false;
        QTimer timer;
        timer.setProperty(LongWork::kRunsMeanwhile, true);
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            if (!work.isShown() || isSent) {
                return;
            }
            for (const auto& [type, x] : input) {
                const bool isUp = type == QEvent::MouseButtonRelease;
                QMouseEvent event(type, {x, 1}, {x, 1},
                                  isUp || type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton,
                                  isUp ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
                QCoreApplication::sendEvent(&pad, &event);
            }
            if (isGivenUp) {
                work.giveUp();
            }
            isSent = true;
        });
        timer.start(1);
        work.run(
            [&] {
                while (!isSent) {
                }
            },
            LongWork::Input::GivesUp);
        EXPECT_TRUE(pad.got.empty()) << "something reached the window while the work lasted";
        QCoreApplication::processEvents();
    }

    LongWork work{StudioWindow::instance().studio().host().gl()};
    Pad pad;
    using Got = std::vector<std::pair<QEvent::Type, double>>;
    static constexpr auto kPress = QEvent::MouseButtonPress, kMove = QEvent::MouseMove,
                          kRelease = QEvent::MouseButtonRelease;
};

TEST_F(LongWorkTest, ADragGoesOnWhereThePointerIsByThen) {
    send({{kMove, 10}, {kMove, 20}, {kMove, 30}});
    EXPECT_EQ(pad.got, (Got{{kMove, 30}}));
}

TEST_F(LongWorkTest, ADragEndsWhereItWasLetGo) {
    send({{kMove, 10}, {kMove, 20}, {kRelease, 20}});
    EXPECT_EQ(pad.got, (Got{{kMove, 20}, {kRelease, 20}}));
}

TEST_F(LongWorkTest, WhatIsPressedMeanwhileIsDropped) {
    send({{kRelease, 5}, {kPress, 10}, {kMove, 20}});
    EXPECT_EQ(pad.got, (Got{{kRelease, 5}}));
}

TEST_F(LongWorkTest, OfADragThatWasGivenUpOnlyTheEndIsLeft) {
    send({{kMove, 10}, {kRelease, 10}}, true);
    EXPECT_EQ(pad.got, (Got{{kRelease, 10}}));
}

} // namespace
} // namespace vs::desktop
