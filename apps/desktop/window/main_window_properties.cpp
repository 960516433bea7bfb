// SPDX-License-Identifier: Apache-2.0
// What the open volume is, and what was unusual about its files.
#include "dialogs/properties_dialog.h"
#include "model/keepers/recovery_keeper.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"
#include "window/action_table.h"
#include "window/main_window.h"
#include "window/notices_badge.h"

#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

namespace vs::desktop {

void MainWindow::makePropertiesAction() {
    actions_->add({"properties", nullptr, tr("Properties…"),
                   tr("File, patient, size, spacing, orientation and values of the volume, and what was "
                      "unusual about its files"),
                   tr("Ctrl+I"), [this] { showProperties(); }, [this] { return isOpen(); }});
}

void MainWindow::addNoticesBadge() {
    auto* badge = new NoticesBadge(studio_.notices());
    badge->setFixedHeight(message_->sizeHint().height()); // the bar stays as high as without it
    connect(badge, &QToolButton::clicked, this, &MainWindow::showProperties);
    statusBar()->addPermanentWidget(badge);
}

void MainWindow::addJournalBadge() {
    auto* badge = named(new QToolButton, "journalBadge", tr("No crash journal"));
    badge->setProperty("badge", true);
    badge->setFocusPolicy(Qt::NoFocus);
    badge->setText(tr("No crash journal"));
    badge->setFixedHeight(message_->sizeHint().height());
    badge->hide();
    connect(recovery_, &RecoveryKeeper::troubleChanged, badge, [this, badge] {
        badge->setToolTip(recovery_->trouble() + '\n' + tr("Click to save the session (Ctrl+S)"));
        badge->setVisible(!recovery_->trouble().isEmpty());
    });
    connect(badge, &QToolButton::clicked, this, &MainWindow::saveSession);
    statusBar()->addPermanentWidget(badge);
}

void MainWindow::showProperties() {
    Notices& notices = studio_.notices();
    auto* dialog = new PropertiesDialog(studio_, this);
    dialog->open();
    notices.markRead();
}

} // namespace vs::desktop
