// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace vs::desktop {

class StudioController;

// The segmentation: intensity range of the run, playback, and what has grown.
class GrowthPanel : public QWidget {
    Q_OBJECT

public:
    explicit GrowthPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    QWidget* makePlayback();
    void takeDocument();
    void takeRange();
    void refresh();

    StudioController& studio_;
    QDoubleSpinBox* lo_;
    QDoubleSpinBox* hi_;
    QCheckBox* autoStart_;
    QSpinBox* speed_;
    QToolButton* play_ = nullptr;
    QToolButton* pause_ = nullptr;
    QToolButton* step_ = nullptr;
    QToolButton* back_ = nullptr;
    QToolButton* end_ = nullptr;
    QLabel* generation_;
    QLabel* voxels_;
    QLabel* millilitres_;
};

} // namespace vs::desktop
