// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QSlider;
class QStackedWidget;

namespace vs::desktop {

class StudioController;

// Settings of the current tool.
class ToolPanel : public QWidget {
    Q_OBJECT

public:
    explicit ToolPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    QWidget* makePeelPage();
    QWidget* makeDrillPage();
    QWidget* makeSeedPage();
    void refresh();

    StudioController& studio_;
    QStackedWidget* pages_;
    QLabel* title_;
    QLabel* layers_ = nullptr;
    QProgressBar* pressure_ = nullptr;
};

} // namespace vs::desktop
