// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dialogs/saving_dialog.h"
#include "model/exports/picture_export.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QSpinBox;

namespace vs::desktop {

// A picture at any size, with or without annotations and background, or a turntable of pictures; shows how
// far it is, and can be given up.
class PictureDialog : public SavingDialog {
    Q_OBJECT

public:
    // `name` is what the file is called at first.
    PictureDialog(StudioController& studio, const QString& name, QWidget* parent);

protected:
    [[nodiscard]] Question question() const override;
    void save(const QString& path) override;

private:
    void makeSizeRow(QFormLayout* form);
    void keepShape(bool isWidth);
    [[nodiscard]] studio::SavePicture settings() const;

    PictureExport export_;
    QString fileName_;
    double shape_ = 1; // width to height of the view
    QSpinBox* width_ = nullptr;
    QSpinBox* height_ = nullptr;
    QCheckBox* keepsShape_ = nullptr;
    QComboBox* background_ = nullptr;
    QCheckBox* annotations_ = nullptr;
    QSpinBox* pictures_ = nullptr;
};

} // namespace vs::desktop
