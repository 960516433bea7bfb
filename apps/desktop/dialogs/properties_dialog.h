// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/texts/volume_texts.h"

#include <QDialog>
#include <QStringList>

class QVBoxLayout;

namespace vs::desktop {

class StudioController;

// What the open volume is, and every notice of reading it; all of it can be copied. Where the volume lies can
// be corrected.
class PropertiesDialog : public QDialog {
    Q_OBJECT

public:
    // A volume must be open. Deletes itself when it closes, which it does when the volume goes.
    PropertiesDialog(StudioController& studio, QWidget* parent);

private:
    void showTable();
    [[nodiscard]] std::vector<Property> properties();
    QWidget* makeTable(const std::vector<Property>& properties);
    QWidget* makeNotices(const QStringList& notices);
    QWidget* makeButtons();

    StudioController& studio_;
    QVBoxLayout* tablePlace_ = nullptr;
};

} // namespace vs::desktop
