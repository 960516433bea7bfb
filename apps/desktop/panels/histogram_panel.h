// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/document/function_editor.h"

#include "field/gradient.h"

#include <QTimer>
#include <QWidget>

#include <optional>

namespace vs::desktop {

class CurvePage;
class RangePage;
class ShapePage;
class StudioController;

// The histograms, one at a time: of intensities with the displayed range; of intensities, of gradient
// magnitudes and of both with the transfer function over them. Below, which transfer function is in use.
class HistogramPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistogramPanel(StudioController& studio, QWidget* parent = nullptr);
    ~HistogramPanel() override;

private:
    void showPage(int page);
    void takeDocument();
    void countAgain();
    void refreshStrip();
    // What gradients need is counted when it is first wanted, in portions.
    void countGradients();
    void takeJoint();

    StudioController& studio_;
    FunctionEditor editor_;
    std::vector<QWidget*> pages_; // of which one is shown
    int shown_ = 0;
    RangePage* range_;
    CurvePage* intensity_;
    CurvePage* gradient_;
    ShapePage* both_;
    std::optional<field::JointCounting> counting_;
    bool isCounted_ = false;
    QTimer countTimer_;
};

} // namespace vs::desktop
