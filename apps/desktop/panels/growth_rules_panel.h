// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QDoubleSpinBox;

namespace vs::desktop {

class ChoiceRow;
class FoldCard;
class HistogramView;
class StudioController;

// What the segment at work may grow into: a range of intensities beside the histogram (the segment's own
// values over the volume's), rules on differences and gradients, which neighbours, and whether tightening
// takes away. A drag is one operation; growing goes on when it is let go.
class GrowthRulesPanel : public QWidget {
    Q_OBJECT

public:
    explicit GrowthRulesPanel(StudioController& studio, QWidget* parent = nullptr);

private:
    // One rule that can be left out: a range with a switch.
    struct Row {
        QCheckBox* isOn = nullptr;
        QDoubleSpinBox* lo = nullptr;
        QDoubleSpinBox* hi = nullptr;
        std::optional<std::optional<Range>> studio::SetGrowthRules::*member = nullptr;
    };

    QWidget* makeRange();
    QWidget* makeRules();
    void takeDocument();
    void takeRange();
    void takeRow(const Row& row);
    void refresh();
    void showOwnValues();

    StudioController& studio_;
    FoldCard* card_;
    HistogramView* histogram_ = nullptr;
    QDoubleSpinBox* lo_ = nullptr;
    QDoubleSpinBox* hi_ = nullptr;
    QCheckBox* takesDisplayed_ = nullptr;
    std::array<Row, 3> rows_;
    ChoiceRow* neighbours_ = nullptr;
    QCheckBox* isLive_ = nullptr;
    bool isShowing_ = false; // what is set is the document's, not the person's
};

} // namespace vs::desktop
