// SPDX-License-Identifier: Apache-2.0
#include "window/main_window.h"

#include "dialogs/saving_dialog.h"
#include "dialogs/series_dialog.h"
#include "model/keepers/recovery_keeper.h"
#include "model/keepers/thumbnail_keeper.h"
#include "model/studio/studio_controller.h"
#include "start/block_dialog.h"
#include "start/welcome_page.h"
#include "view/view_widget.h"

#include "volume/io/read.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>

namespace vs::desktop {

// Dialogs that are open are dropped: nothing is asked over them. False: one of them is at work, or asks for
// what this would ask too.
bool MainWindow::closeDialogs() {
    while (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        const auto* saving = qobject_cast<const SavingDialog*>(dialog);
        if (isLeaving_ || (saving != nullptr && saving->isSaving())) {
            dialog->raise();
            return false;
        }
        dialog->reject();
        if (dialog->isVisible()) {
            return false;
        }
    }
    return true;
}

// Asks before work that no file holds is lost; false: the person wants to stay.
bool MainWindow::mayLeave() {
    if (!closeDialogs()) {
        return false;
    }
    isLeaving_ = true;
    const bool isAgreed = !studio_.files().hasUnsavedEdits() || agreesToLeave();
    isLeaving_ = false;
    return isAgreed;
}

bool MainWindow::agreesToLeave() {
    QMessageBox question(QMessageBox::Warning, tr("Volume Studio"),
                         tr("There are edits that no session file holds."), QMessageBox::NoButton, this);
    question.setObjectName("unsavedEdits");
    question.setInformativeText(tr("Save the session before leaving it?"));
    const bool mustAsk = studio_.files().source().session.empty();
    auto* save = question.addButton(mustAsk ? tr("&Save…") : tr("&Save"), QMessageBox::AcceptRole);
    auto* discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    auto* cancel = question.addButton(tr("&Cancel"), QMessageBox::RejectRole);
    save->setObjectName("saveEdits");
    discard->setObjectName("discardEdits");
    cancel->setObjectName("cancelLeaving");
    question.setDefaultButton(save);
    question.exec();
    if (question.clickedButton() == save) {
        return saveBeforeLeaving();
    }
    return question.clickedButton() == discard;
}

// False: no name was chosen, or it could not be written; the message says why.
bool MainWindow::saveBeforeLeaving() {
    const auto session = studio_.files().source().session;
    if (!session.empty()) {
        return studio_.files().saveSession(session);
    }
    bool isSaved = false;
    auto* dialog = makeFileDialog("saveDialog", tr("Save the session"), true, tr("Sessions (*.json)"),
                                  suggestedSession());
    connect(dialog, &QFileDialog::fileSelected, this, [this, &isSaved](const QString& path) {
        isSaved = studio_.files().saveSession(path.toStdString());
    });
    dialog->exec();
    return isSaved;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(mayLeave());
    if (event->isAccepted()) {
        thumbnails_->keep();
        recovery_->finish();
    }
}

void MainWindow::recoverLost(const studio::LostWork& lost) {
    OpenRequest request;
    request.journal = lost.journal;
    recover(request);
}

void MainWindow::recover(const OpenRequest& request) {
    if (!recovery_->recover(request)) {
        studio_.host().say(tr("It is being recovered in another window"));
        welcome_->refresh();
    }
}

void MainWindow::open(const OpenRequest& request) {
    // What no reader knows is refused without a question: nothing is left for it.
    const bool isRefused = request.rawLayout.empty() && volume::isHeaderless(request.volume);
    if (isRefused || mayLeave()) {
        thumbnails_->keep();
        studio_.files().open(request);
    }
}

void MainWindow::chooseSeries(const OpenRequest& request, const std::vector<volume::SeriesChoice>& choices) {
    auto* dialog = new SeriesDialog(request, choices, this);
    connect(dialog, &SeriesDialog::chosen, &studio_.files(), &DocumentFiles::open);
    dialog->open();
}

void MainWindow::askForBlock() {
    auto* dialog = new BlockDialog(this);
    // Once the dialog has closed: what is asked then does not stand over it.
    connect(dialog, &BlockDialog::chosen, this, &MainWindow::open, Qt::QueuedConnection);
    dialog->open();
}

void MainWindow::leaveForStartScreen() {
    if (mayLeave()) {
        thumbnails_->keep();
        studio_.files().close();
        showStartScreen();
    }
}

// Panels have nothing to show there.
void MainWindow::showStartScreen() {
    for (QDockWidget* dock : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        if (!dock->isHidden()) {
            dock->hide();
            hiddenDocks_.push_back(dock);
        }
    }
    centre_->setCurrentWidget(welcome_);
    setWindowTitle(tr("Volume Studio"));
    volume_->clear();
    probe_->clear();
    welcome_->setFocus();
}

void MainWindow::showView() {
    for (QDockWidget* dock : hiddenDocks_) {
        dock->show();
    }
    hiddenDocks_.clear();
    centre_->setCurrentIndex(1);
    view_->setFocus();
}

// The journal has all that was done, and is let go of when the program ends: the one that is started in its
// place offers it.
void MainWindow::startAgain() {
    QMessageBox told(QMessageBox::Critical, tr("Volume Studio"), tr("The graphics driver was reset."),
                     QMessageBox::NoButton, this);
    told.setObjectName("deviceLost");
    told.setInformativeText(
        tr("What you have done is kept. Volume Studio starts again and offers to go on with it."));
    told.addButton(tr("&Start again"), QMessageBox::AcceptRole)->setObjectName("startAgain");
    told.exec();
    QApplication::exit(kStartsAgain);
}

} // namespace vs::desktop
