// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/settings/preferences.h"

#include <QDialog>

class QFormLayout;
class QSpinBox;

namespace vs::desktop {

// Shows the preferences; each change counts at once.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    // Deletes itself when it closes.
    PreferencesDialog(const Preferences& preferences, QWidget* parent);

signals:
    void changed(const vs::desktop::Preferences& preferences);

private:
    void addTheme(QFormLayout* form);
    void addLanguage(QFormLayout* form);
    void addUndo(QFormLayout* form);
    void addScans(QFormLayout* form);
    void addRecordings(QFormLayout* form);
    void addQuality(QFormLayout* form);
    void addSlices(QFormLayout* form);
    // For megabytes; where none are allowed, that leaves them to the program.
    QSpinBox* makeAmount(const char* objectName, const QString& label, int least,
                         int Preferences::*megabytes);
    void tell() { emit changed(preferences_); }

    Preferences preferences_;
};

} // namespace vs::desktop
