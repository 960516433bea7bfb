// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace vs::desktop {

class PlayTool;

// The strip of steps below the picture while a session is played: which step it is and what is done in it, a
// button for each to go there, and how it is played. Shown only while there is something to play.
class PlayStrip : public QWidget {
    Q_OBJECT

public:
    explicit PlayStrip(PlayTool& tool, QWidget* parent = nullptr);

private:
    void makeSteps();
    void refresh();
    void toggle();

    PlayTool& tool_;
    QLabel* text_;
    QWidget* row_; // of the steps' buttons
    std::vector<QToolButton*> steps_;
    QToolButton* play_;
    QToolButton* next_;
    QToolButton* back_;
    QComboBox* speed_;
};

} // namespace vs::desktop
