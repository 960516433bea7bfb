// SPDX-License-Identifier: Apache-2.0
#include "dialogs/saving_dialog.h"

#include "model/studio/studio_controller.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace vs::desktop {

void SavingDialog::lock() {
    fields_->setEnabled(false);
    save_->setEnabled(false);
    message_->hide();
    progress_->show();
}

void SavingDialog::finish(bool isDone, const QString& message) {
    studio_.host().say(message);
    progress_->hide();
    fields_->setEnabled(true);
    save_->setEnabled(true);
    if (isDone) {
        accept();
    } else {
        message_->setText(message);
        message_->show();
    }
}

void SavingDialog::reject() {
    if (isSaving()) {
        giveUp();
    } else {
        QDialog::reject();
    }
}

} // namespace vs::desktop
