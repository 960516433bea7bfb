// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace vs::desktop {

class PortionedExport;
class StudioController;

// A dialog that asks for a file, writes it and stays open while it does: its fields are locked, a bar shows
// how far it is, Cancel gives up and leaves it open; what went wrong stands in it.
class SavingDialog : public QDialog {
    Q_OBJECT

public:
    // `name` is what the dialog and its parts are called in scripts: "picture" makes "pictureDialog",
    // "pictureSave" ...
    SavingDialog(StudioController& studio, const QString& name, QWidget* parent);

    [[nodiscard]] bool isSaving() const;

protected:
    // What the dialog for the file asks: its title and filter, where it begins, the suffix (without a dot) of
    // files named without one, and what the file is called at first.
    struct Question {
        QString title;
        QString filter;
        QString folder;
        QString suffix;
        QString name;
    };
    [[nodiscard]] virtual Question question() const = 0;
    // Locks the dialog and begins to write.
    virtual void save(const QString& path) = 0;

    // The bar, the message and the buttons below the fields, and what it is that they begin and give up.
    void addBottom(QVBoxLayout* column, PortionedExport& writing, const QString& saveText,
                   const QString& saveName);
    void lock(int steps);   // it begins; 0: nobody knows yet how far it is
    void reject() override; // while it runs: gives up, and stays open

    StudioController& studio_;
    QWidget* fields_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton* save_ = nullptr;

private:
    void askWhere();
    void finish(bool isDone, const QString& message); // it has ended; done: the dialog closes

    QString name_;
    PortionedExport* writing_ = nullptr; // the subclass has it
    QProgressBar* progress_ = nullptr;
};

} // namespace vs::desktop
