// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace vs::desktop {

class FoldCard;
class StudioController;

// Numbers of the segment at work: voxels and volume live, intensities, size and surface when it has come to
// rest; those of all segments are copied as CSV.
class SegmentNumbersPanel : public QWidget {
    Q_OBJECT

public:
    explicit SegmentNumbersPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    void refreshLive();
    void refreshMeasured();
    void copy();

    StudioController& studio_;
    FoldCard* card_;
    QLabel* voxels_;
    QLabel* millilitres_;
    QLabel* mean_;
    QLabel* extremes_;
    QLabel* box_;
    QLabel* surface_;
    QLabel* sphericity_;
    QLabel* axes_;
    QLabel* topology_;
    QLabel* euler_;
    QPushButton* copy_;
};

} // namespace vs::desktop
