// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QDoubleSpinBox;

namespace vs::desktop {

class HistogramView;
class StudioController;

// The displayed range: by dragging on the histogram, or typed.
class HistogramPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistogramPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    void takeDocument();
    void refresh();

    StudioController& studio_;
    HistogramView* view_;
    QDoubleSpinBox* lo_;
    QDoubleSpinBox* hi_;
};

} // namespace vs::desktop
