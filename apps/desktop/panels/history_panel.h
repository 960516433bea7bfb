// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/edits/history_travel.h"

#include <QDockWidget>

class QListWidget;

namespace vs::desktop {

class StudioController;

// The steps that undo and redo go through, one a row, the oldest first. A click goes to the state after that
// step; those that could be redone are greyed.
class HistoryPanel : public QDockWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(StudioController& studio);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override; // what is greyed has a colour of the theme

private:
    void refresh();
    void addRow(const char* iconName, const QString& text, bool holds);

    StudioController& studio_;
    HistoryTravel travel_;
    QListWidget* list_;
    std::size_t seenOperations_ = 0;
};

} // namespace vs::desktop
