// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/document/geometry_draft.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace vs::desktop {

class CorrectionPicture;
class StudioController;

// Corrects where the open scan lies: its slices are turned until they look right, spacings are typed, and all
// of it becomes one operation. A volume must be open for as long as it is there.
class GeometryCard : public QWidget {
    Q_OBJECT

public:
    explicit GeometryCard(StudioController& studio);

private:
    QWidget* makeSlice(render::SliceKind kind);
    QWidget* makeSpacings();
    QWidget* makeButtons();
    void takeSpacing();
    void apply();
    // Shows what the draft has come to.
    void refresh();
    [[nodiscard]] QString meaning() const;

    StudioController& studio_;
    GeometryDraft draft_;
    std::array<CorrectionPicture*, 3> pictures_{};
    std::array<QDoubleSpinBox*, 3> spacings_{};
    QLabel* meaning_ = nullptr;
    QPushButton* asInFile_ = nullptr;
    QPushButton* apply_ = nullptr;
};

} // namespace vs::desktop
