// SPDX-License-Identifier: Apache-2.0
#include "dialogs/saving_dialog.h"

#include "model/exports/portioned_export.h"
#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"

#include <QFileDialog>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace vs::desktop {

SavingDialog::SavingDialog(StudioController& studio, const QString& name, QWidget* parent)
    : QDialog(parent), studio_(studio), name_(name) {
    setObjectName(name + "Dialog");
}

bool SavingDialog::isSaving() const { return writing_->isRunning(); }

void SavingDialog::addBottom(QVBoxLayout* column, PortionedExport& writing, const QString& saveText,
                             const QString& saveName) {
    writing_ = &writing;
    const auto scriptName = [this](const char* part) { return (name_ + part).toLatin1(); };
    progress_ = named(new QProgressBar, scriptName("Progress"), tr("Progress"));
    progress_->setTextVisible(false);
    progress_->hide();
    column->addWidget(progress_);
    message_ = named(makeQuietLabel({}), scriptName("Message"), tr("Message"));
    message_->setWordWrap(true);
    message_->hide();
    column->addWidget(message_);
    auto* row = new QHBoxLayout;
    save_ = named(new QPushButton(saveText), scriptName("Save"), saveName);
    save_->setDefault(true);
    auto* close = named(new QPushButton(tr("Cancel")), scriptName("Cancel"), tr("Cancel"));
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(save_);
    column->addLayout(row);
    connect(save_, &QPushButton::clicked, this, &SavingDialog::askWhere);
    connect(close, &QPushButton::clicked, this, &SavingDialog::reject);
    connect(writing_, &PortionedExport::progressed, this, [this](int done, int total) {
        progress_->setRange(0, total);
        progress_->setValue(done);
    });
    connect(writing_, &PortionedExport::finished, this, &SavingDialog::finish);
}

void SavingDialog::askWhere() {
    const Question asked = question();
    auto* dialog = new QFileDialog(this, asked.title, asked.folder, asked.filter);
    dialog->setObjectName(name_ + "FileDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(asked.suffix);
    dialog->selectFile(asked.name);
    connect(dialog, &QFileDialog::fileSelected, this, &SavingDialog::save);
    dialog->open();
}

void SavingDialog::lock(int steps) {
    progress_->setRange(0, steps);
    progress_->setValue(0);
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
        writing_->cancel();
    } else {
        QDialog::reject();
    }
}

} // namespace vs::desktop
