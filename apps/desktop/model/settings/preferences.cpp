// SPDX-License-Identifier: Apache-2.0
#include "model/settings/preferences.h"

#include "model/settings/settings.h"

#include <algorithm>

namespace vs::desktop {

Preferences Preferences::load() {
    const Settings settings;
    Preferences preferences;
    const QString theme = settings.value("theme").toString();
    preferences.theme = theme == "light" ? Theme::Light : theme == "desktop" ? Theme::Desktop : Theme::Dark;
    const QString language = settings.value("language").toString();
    preferences.language = language == "en"   ? Language::English
                           : language == "de" ? Language::German
                                              : Language::Desktop;
    preferences.undoMegabytes =
        std::clamp(settings.value("undoMegabytes", preferences.undoMegabytes).toInt(), 16, 1 << 20);
    preferences.deviceMegabytes = std::clamp(settings.value("deviceMegabytes").toInt(), 0, 1 << 20);
    preferences.hostMegabytes = std::clamp(settings.value("hostMegabytes").toInt(), 0, 1 << 20);
    preferences.recordings = settings.value("recordings").toString();
    preferences.smoothSampling = settings.value("smoothSampling").toBool();
    preferences.shadows = settings.value("shadows").toBool();
    preferences.sliceWindow = settings.value("sliceWindow").toString();
    preferences.tintsSlices = settings.value("tintSlices").toBool();
    preferences.firstStrokePercent =
        std::clamp(settings.value("firstStrokePercent", preferences.firstStrokePercent).toInt(), 0, 100);
    preferences.turntable = settings.value("turntable").toBool();
    return preferences;
}

void Preferences::save() const {
    Settings settings;
    settings.setValue("theme", theme == Theme::Light     ? "light"
                               : theme == Theme::Desktop ? "desktop"
                                                         : "dark");
    settings.setValue("language", language == Language::English  ? "en"
                                  : language == Language::German ? "de"
                                                                 : "desktop");
    settings.setValue("undoMegabytes", undoMegabytes);
    settings.setValue("deviceMegabytes", deviceMegabytes);
    settings.setValue("hostMegabytes", hostMegabytes);
    settings.setValue("recordings", recordings);
    settings.setValue("smoothSampling", smoothSampling);
    settings.setValue("shadows", shadows);
    settings.setValue("sliceWindow", sliceWindow);
    settings.setValue("tintSlices", tintsSlices);
    settings.setValue("firstStrokePercent", firstStrokePercent);
    settings.setValue("turntable", turntable);
}

} // namespace vs::desktop
