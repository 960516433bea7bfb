// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace vs::desktop {

class StudioController;

// A dialog that writes something and stays open while it does: its fields are locked, a bar shows how far it
// is, Cancel gives up and leaves it open; what went wrong stands in it. Subclasses make the widgets.
class SavingDialog : public QDialog {
    Q_OBJECT

public:
    SavingDialog(StudioController& studio, QWidget* parent) : QDialog(parent), studio_(studio) {}

    [[nodiscard]] virtual bool isSaving() const = 0;

protected:
    virtual void giveUp() = 0;

    void lock();                                      // it begins; the bar's range is the subclass's
    void finish(bool isDone, const QString& message); // it has ended; done: the dialog closes
    void reject() override;                           // while it runs: gives up, and stays open

    StudioController& studio_;
    QWidget* fields_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton* save_ = nullptr;
};

} // namespace vs::desktop
