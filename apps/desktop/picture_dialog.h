// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture_export.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace vs::desktop {

// A picture at any size, with or without annotations and background, or a turntable of pictures; shows how
// far it is, and can be given up.
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    // `name` is what the file is called at first.
    PictureDialog(StudioController& studio, const QString& name, QWidget* parent);

protected:
    void reject() override; // while it runs: gives up, and stays open

private:
    void makeSizeRow(QFormLayout* form);
    void keepShape(bool isWidth);
    void askWhere();
    void save(const QString& path);
    void finish(bool isDone, const QString& message);
    [[nodiscard]] studio::SavePicture settings() const;

    StudioController& studio_;
    PictureExport export_;
    QString name_;
    double shape_ = 1; // width to height of the view
    QSpinBox* width_ = nullptr;
    QSpinBox* height_ = nullptr;
    QCheckBox* keepsShape_ = nullptr;
    QComboBox* background_ = nullptr;
    QCheckBox* annotations_ = nullptr;
    QSpinBox* pictures_ = nullptr;
    QWidget* fields_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton* save_ = nullptr;
};

} // namespace vs::desktop
