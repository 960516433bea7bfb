// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QAction;
class QGridLayout;

namespace vs::desktop {

// Buttons of actions in two columns, so that all tools are in sight on a small screen too.
class ToolColumn : public QWidget {
    Q_OBJECT

public:
    explicit ToolColumn(QWidget* parent = nullptr);

    void add(QAction* action);
    // What follows begins a new row, below a line.
    void addSeparator();

private:
    QGridLayout* grid_;
    int next_ = 0;  // place in the grid, row by row
    int width_ = 0; // of each button
};

} // namespace vs::desktop
