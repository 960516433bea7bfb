// SPDX-License-Identifier: Apache-2.0
// Input while the document is at work and nothing else can be done.
#include "engine/long_work.h"
#include "studio_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>
#include <QUrl>
#include <QWidget>

#include <atomic>
#include <functional>
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
    // Does something in the window while work lasts that can be given up.
    void meanwhile(const std::function<void()>& act) {
        std::atomic<bool> isDone = false;
        QTimer timer;
        timer.setProperty(LongWork::kRunsMeanwhile, true);
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            if (!isDone && work.isShown()) {
                act();
                isDone = true;
            }
        });
        timer.start(1);
        work.run(
            [&] {
                while (!isDone) {
                }
            },
            LongWork::Input::GivesUp);
    }

    // What reaches the pad of what is sent to it while work lasts.
    void send(const std::vector<std::pair<QEvent::Type, double>>& input, bool isGivenUp = false) {
        meanwhile([&] {
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
        });
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

TEST_F(LongWorkTest, FilesFromOtherProgramsAreWelcomeMeanwhile) {
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile("/a/scan.nrrd")});
    bool isWelcome = false;
    meanwhile([&] {
        QDragEnterEvent event({1, 1}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&StudioWindow::instance().window(), &event);
        isWelcome = event.isAccepted() && event.dropAction() == Qt::CopyAction;
    });
    EXPECT_TRUE(isWelcome);
}

TEST_F(LongWorkTest, FilesDroppedMeanwhileAreOpenedAfterwards) {
    auto& studio = StudioWindow::instance();
    studio.open();
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile("/none/scan.json")});
    const auto said = [&] { return studio.studio().host().message().contains("/none/scan.json"); };
    bool isSaidMeanwhile = false;
    studio.studio().host().runLong([&] {
        std::atomic<bool> isDone = false;
        QMetaObject::invokeMethod(qApp, [&] {
            QDropEvent event({1, 1}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&studio.window(), &event);
            QTimer::singleShot(0, qApp, [&] { // after what the drop has asked for
                isSaidMeanwhile = said();
                isDone = true;
            });
        });
        while (!isDone) {
        }
    });
    EXPECT_FALSE(isSaidMeanwhile);
    studio.wait("the refusal",
                [&] { return studio.window().findChild<QWidget*>("closeOpenFailed") != nullptr; });
    EXPECT_TRUE(said()) << studio.studio().host().message().toStdString();
    studio.part<QPushButton>("closeOpenFailed").click();
    studio.open();
}

} // namespace
} // namespace vs::desktop
