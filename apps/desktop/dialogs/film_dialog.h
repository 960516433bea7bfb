// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/filming.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;
class QSpinBox;
class QVBoxLayout;

namespace vs::desktop {

class StudioController;

// A film of what is open: around it, as it grew, as it was made, or through views that the person adds one by
// one, since the window stays free beside the dialog. Shows any moment of it before it is made.
class FilmDialog : public QDialog {
    Q_OBJECT

public:
    // `name` is what the file is called at first, without an ending.
    FilmDialog(StudioController& studio, const QString& name, QWidget* parent);

private:
    void makePreview(QVBoxLayout* column);
    void makeFields(QFormLayout* form);
    void makeKeys(QFormLayout* form);
    void makeButtons(QVBoxLayout* column);
    // What is chosen fits the fields that are shown.
    void follow();
    void addKey();
    void removeKey();
    void listKeys();
    void previewSoon();
    void preview();
    void askWhere();
    void save(const QString& path);
    void tell(const QString& message);
    [[nodiscard]] studio::SaveMovie film() const;
    [[nodiscard]] studio::Shot shot() const;

    StudioController& studio_;
    QString name_;
    std::vector<studio::FilmKey> keys_;
    QComboBox* what_ = nullptr;
    QDoubleSpinBox* seconds_ = nullptr;
    QSpinBox* degrees_ = nullptr;
    QDoubleSpinBox* factor_ = nullptr;
    QCheckBox* turns_ = nullptr;
    QComboBox* size_ = nullptr;
    QComboBox* rate_ = nullptr;
    QComboBox* background_ = nullptr;
    QCheckBox* annotations_ = nullptr;
    QListWidget* keyList_ = nullptr;
    QPushButton* addKey_ = nullptr;
    QPushButton* removeKey_ = nullptr;
    QFormLayout* form_ = nullptr;
    QWidget* keyRow_ = nullptr;
    QLabel* picture_ = nullptr;
    QSlider* time_ = nullptr;
    QLabel* timeText_ = nullptr;
    QPushButton* play_ = nullptr;
    QPushButton* save_ = nullptr;
    QLabel* message_ = nullptr;
    bool isTroubled_ = false; // the message says why there is no preview
    QTimer previewing_;
    QTimer playing_;
};

} // namespace vs::desktop
