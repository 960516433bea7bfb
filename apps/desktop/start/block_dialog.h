// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "engine/volume_loader.h"

#include <QDialog>

#include <array>

class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace vs::desktop {

// Asks what is sculpted from when there is no scan: a block of a chosen size and spacing, which is carved or
// which is empty and is built up.
class BlockDialog : public QDialog {
    Q_OBJECT

public:
    // Deletes itself when it closes.
    explicit BlockDialog(QWidget* parent);

signals:
    void chosen(const vs::desktop::OpenRequest& request);

private:
    void addSize(QFormLayout* form);
    void addSpacing(QFormLayout* form);
    void addBeginning(QFormLayout* form);
    void addPrecision(QFormLayout* form);
    void showTotal();
    [[nodiscard]] OpenRequest request() const;

    std::array<QSpinBox*, 3> size_{};
    std::array<QDoubleSpinBox*, 3> spacing_{};
    QLabel* total_ = nullptr;
    NewBlock block_;
};

} // namespace vs::desktop
