// SPDX-License-Identifier: Apache-2.0
#include "dialogs/picture_dialog.h"

#include "model/studio/studio_controller.h"
#include "parts/panel_parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

namespace vs::desktop {

namespace {

constexpr int kLargest = 8192; // pixels; what every device can hold
constexpr int kMostPictures = 720;

QSpinBox* makePixels(const char* name, const QString& accessibleName, int value) {
    auto* box = named(new QSpinBox, name, accessibleName);
    box->setRange(16, kLargest);
    box->setValue(value);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    return box;
}

} // namespace

PictureDialog::PictureDialog(StudioController& studio, const QString& name, QWidget* parent)
    : SavingDialog(studio, "picture", parent), export_(studio), fileName_(name) {
    setWindowTitle(tr("Save pictures"));
    auto* column = new QVBoxLayout(this);
    fields_ = new QWidget;
    auto* form = makeForm(fields_);
    makeSizeRow(form);
    background_ = named(new QComboBox, "pictureBackground", tr("Background"));
    for (const auto& [text, value] :
         {std::pair(tr("As in the window"), "studio"), std::pair(tr("White"), "white"),
          std::pair(tr("Black"), "black"), std::pair(tr("Transparent"), "transparent")}) {
        background_->addItem(text, value);
    }
    form->addRow(tr("Background"), background_);
    annotations_ = makeCheckBox("pictureAnnotations", tr("Scale bar and orientation marker"),
                                tr("Draws both into the picture"), true);
    form->addRow(QString(), annotations_);
    pictures_ = named(new QSpinBox, "pictureCount", tr("Pictures all the way around"));
    pictures_->setRange(1, kMostPictures);
    pictures_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    pictures_->setSpecialValueText(tr("one picture, as seen"));
    pictures_->setSuffix(tr(" pictures around"));
    pictures_->setToolTip(tr("More than one: a turntable, as numbered files for a film"));
    form->addRow(tr("Turntable"), pictures_);
    column->addWidget(fields_);
    addBottom(column, export_, tr("Save\u2026"), tr("Save"));
}

void PictureDialog::makeSizeRow(QFormLayout* form) {
    const glm::ivec2 seen = glm::max(studio_.picture().viewport(), glm::ivec2(1));
    shape_ = double(seen.x) / seen.y;
    width_ = makePixels("pictureWidth", tr("Width in pixels"), seen.x);
    height_ = makePixels("pictureHeight", tr("Height in pixels"), seen.y);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(width_);
    row->addWidget(makeQuietLabel(tr("by")));
    row->addWidget(height_);
    row->addWidget(makeQuietLabel(tr("pixels")));
    row->addStretch(1);
    form->addRow(tr("Size"), row);
    keepsShape_ = makeCheckBox("pictureKeepShape", tr("The shape of the view"),
                               tr("Width and height go together"), true);
    form->addRow(QString(), keepsShape_);
    connect(width_, &QSpinBox::valueChanged, this, [this] { keepShape(true); });
    connect(height_, &QSpinBox::valueChanged, this, [this] { keepShape(false); });
}

void PictureDialog::keepShape(bool isWidth) {
    if (keepsShape_->isChecked()) {
        QSpinBox* other = isWidth ? height_ : width_;
        const QSignalBlocker blocker(other);
        other->setValue(int(std::lround(isWidth ? width_->value() / shape_ : height_->value() * shape_)));
    }
}

studio::SavePicture PictureDialog::settings() const {
    studio::SavePicture picture;
    picture.size = {width_->value(), height_->value()};
    picture.background = render::backgroundFromName(background_->currentData().toString().toStdString());
    picture.annotations = annotations_->isChecked();
    return picture;
}

SavingDialog::Question PictureDialog::question() const {
    return {tr("Save the picture"), tr("Pictures (*.png)"), {}, "png", fileName_};
}

void PictureDialog::save(const QString& path) {
    const std::filesystem::path file(path.toStdString());
    auto picture = settings();
    picture.file = file.filename().string();
    lock(0);
    export_.save(picture, file.parent_path(), pictures_->value());
}

} // namespace vs::desktop
