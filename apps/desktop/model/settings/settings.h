// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSettings>

namespace vs::desktop {

// The person's own settings: ~/.config/volume-studio/volume-studio.ini, or where XDG_CONFIG_HOME says.
class Settings : public QSettings {
public:
    Settings() : QSettings(QSettings::IniFormat, QSettings::UserScope, "volume-studio", "volume-studio") {}
};

} // namespace vs::desktop
