// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace vs::desktop {

class HistogramView;
class StudioController;

// The displayed range: by dragging on the histogram, or typed. At rest the histogram also shows which voxels
// the cuts have left to be seen.
class RangePage : public QWidget {
    Q_OBJECT

public:
    explicit RangePage(StudioController& studio);

    // Takes in a volume that was opened.
    void takeDocument();
    // The colours of what is displayed, over intensity; null: not by intensity.
    void setColourStrip(const std::function<QColor(double)>& colourAt);

private:
    QWidget* makeRangeRow();
    QWidget* makeSmoothingRow();
    void takeTyped();
    void refresh();
    void countVisible();
    // Says what was wrong with what was typed; empty: nothing.
    void answer(const QString& words);

    StudioController& studio_;
    HistogramView* view_;
    QDoubleSpinBox* lo_ = nullptr;
    QDoubleSpinBox* hi_ = nullptr;
    QDoubleSpinBox* smoothing_ = nullptr;
    QLabel* unit_ = nullptr;
    QToolButton* logarithmic_ = nullptr;
    QLabel* note_;
    QTimer countTimer_;
};

} // namespace vs::desktop
