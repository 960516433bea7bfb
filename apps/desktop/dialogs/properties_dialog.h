// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/texts/volume_texts.h"

#include <QDialog>
#include <QStringList>

class QVBoxLayout;

namespace vs::desktop {

// What the open volume is, and every notice of reading it. All of it can be copied.
class PropertiesDialog : public QDialog {
    Q_OBJECT

public:
    // Deletes itself when it closes.
    PropertiesDialog(const std::vector<Property>& properties, const QStringList& notices, QWidget* parent);

private:
    QWidget* makeTable(const std::vector<Property>& properties);
    QWidget* makeNotices(const QStringList& notices);
    QWidget* makeButtons(const QString& asText);
};

} // namespace vs::desktop
