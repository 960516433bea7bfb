// SPDX-License-Identifier: Apache-2.0
// The question about edits that no file holds stands over no other dialog, and is asked once.
#include "model/segments/segment_controller.h"
#include "studio_window.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>
#include <QTimer>
#include <QUrl>

namespace vs::desktop {
namespace {

std::vector<std::string> dialogs() {
    std::vector<std::string> names;
    for (const QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->isVisible() && qobject_cast<const QDialog*>(widget) != nullptr) {
            names.push_back(widget->objectName().toStdString());
        }
    }
    return names;
}

QDialog* modal() { return qobject_cast<QDialog*>(QApplication::activeModalWidget()); }

class Leaving : public testing::Test {
protected:
    using Names = std::vector<std::string>;

    void SetUp() override {
        w.open();
        w.studio().segments().add();
        ASSERT_TRUE(w.studio().files().hasUnsavedEdits());
    }
    void TearDown() override {
        while (auto* dialog = modal()) {
            dialog->reject();
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    // Leaves some way, and stays when asked. What dialogs were open then, each time that it was asked.
    std::vector<Names> asked(const std::function<void()>& leave) {
        std::vector<Names> seen;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            if (auto* dialog = modal(); dialog != nullptr && dialog->objectName() == "unsavedEdits") {
                seen.push_back(dialogs());
                w.window().close(); // once more
                dialog->findChild<QAbstractButton*>("cancelLeaving")->click();
            }
        });
        timer.start(10);
        leave();
        QTest::qWait(100);
        return seen;
    }
    QDialog& open(const char* action) {
        w.trigger(action);
        StudioWindow::wait(action, [] { return modal() != nullptr; });
        return *modal();
    }

    StudioWindow& w = StudioWindow::instance();
    const std::vector<Names> alone{{"unsavedEdits"}};
};

TEST_F(Leaving, AsksOverNoDialogThatIsOpen) {
    for (const char* action : {"preferences", "shortcuts", "about", "exportPicture", "export", "open",
                               "openFolder", "saveSession", "screenshot"}) {
        open(action);
        EXPECT_EQ(asked([&] { w.window().close(); }), alone) << action;
        EXPECT_TRUE(w.window().isVisible()) << action;
        EXPECT_EQ(dialogs(), Names()) << action;
    }
}

TEST_F(Leaving, AsksOverNoDialogThatChoosesWhatIsOpened) {
    QDialog& dialog = open("open");
    dialog.findChild<QLineEdit*>("fileNameEdit")
        ->setText(QString::fromStdString(StudioWindow::volume.string()));
    EXPECT_EQ(asked([&] { dialog.accept(); }), alone);
    EXPECT_TRUE(w.studio().files().hasUnsavedEdits()) << "the volume stayed";
}

TEST_F(Leaving, TheStartScreenAndAnotherVolumeAskOverNone) {
    open("preferences");
    EXPECT_EQ(asked([&] { w.trigger("startScreen"); }), alone);
    open("shortcuts");
    EXPECT_EQ(asked([&] { w.window().openPath(QString::fromStdString(StudioWindow::volume.string())); }),
              alone);
}

TEST_F(Leaving, NothingIsDroppedOnADialog) {
    const auto isTaken = [&] {
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile(QString::fromStdString(StudioWindow::volume.string()))});
        QDragEnterEvent event({50, 50}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&w.window(), &event);
        return event.isAccepted();
    };
    open("preferences");
    EXPECT_FALSE(isTaken());
    modal()->reject();
    EXPECT_TRUE(isTaken());
}

} // namespace
} // namespace vs::desktop
