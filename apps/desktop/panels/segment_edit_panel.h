// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace vs::desktop {

class FoldCard;
class StudioController;
class ToolBox;

// Edits of the segment at work, finished or not, and cuts by it: what to do, by how much, with which other.
class SegmentEditPanel : public QWidget {
    Q_OBJECT

public:
    SegmentEditPanel(StudioController& studio, ToolBox& tools, QWidget* parent = nullptr);

private:
    void show();
    void refresh();
    void perform();

    StudioController& studio_;
    ToolBox& tools_;
    FoldCard* card_;
    QComboBox* edit_;
    QLabel* explanation_;
    QWidget* amountRow_;
    QDoubleSpinBox* amount_;
    QLabel* amountText_;
    QWidget* otherRow_;
    QComboBox* other_;
    QPushButton* perform_;
};

} // namespace vs::desktop
