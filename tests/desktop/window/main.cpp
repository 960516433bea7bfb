// SPDX-License-Identifier: Apache-2.0
// Tests in the window's own process, for what no X server without hardware can send: a pen with pressure,
// fingers; and for what only the process itself knows of its widgets.
#include "model/settings/preferences.h"
#include "parts/theme.h"
#include "studio_window.h"

#include <gtest/gtest.h>

#include <QApplication>

#include <clocale>
#include <iostream>
#include <string_view>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc != 4) {
        std::cerr << "usage: vs_window_tests VOLUME FOLDER en|de\n";
        return 2;
    }
    QApplication application(argc, argv);
    QApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
    QApplication::setApplicationName("volume-studio");
    std::setlocale(LC_NUMERIC, "C");
    using vs::desktop::Language;
    vs::desktop::speak(application, std::string_view(argv[3]) == "de" ? Language::German : Language::English);
    vs::desktop::applyTheme(application, vs::desktop::Preferences::load().theme);
    vs::desktop::StudioWindow::volume = argv[1];
    vs::desktop::StudioWindow::folder = argv[2];
    const int result = RUN_ALL_TESTS();
    vs::desktop::StudioWindow::instance().close();
    return result;
}
