// SPDX-License-Identifier: Apache-2.0
#include "engine/rehearsal.h"
#include "engine/watched_application.h"
#include "model/keepers/rehearsal_keeper.h"
#include "model/settings/preferences.h"
#include "model/studio/studio_controller.h"
#include "model/texts/language.h"
#include "parts/desktop_appearance.h"
#include "parts/theme.h"
#include "testing/latency_recorder.h"
#include "testing/layout_reporter.h"
#include "tools/tool_box.h"
#include "view/view_widget.h"
#include "window/main_window.h"
#include "window/options.h"

#include "base/error.h"
#include "base/large_pages.h"
#include "base/log.h"
#include "volume/reading/decoder_at_hand.h"

#include <QIcon>
#include <QMessageBox>
#include <QScreen>

#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

// Becomes the program anew, without what was opened. Returns where that cannot be.
void startAgain(const vs::desktop::Options& options) {
    std::vector<std::string> arguments{"volume-studio"};
    if (!options.layoutFile.empty()) {
        arguments.insert(arguments.end(), {"--layout-file", options.layoutFile.string()});
    }
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    execv("/proc/self/exe", pointers.data());
    vs::logNotice("the program could not be started again; start it by hand");
}

int run(vs::desktop::WatchedApplication& application) {
    using namespace vs::desktop;
    speak(application, Preferences::load().language);
    const Options options = parseOptions(application);
    std::optional<vs::volume::DecoderAtHand> decoder(std::in_place); // for all that is opened
    applyTheme(application, Preferences::load().theme);
    const DesktopAppearance desktop(application);
    QObject::connect(&desktop, &DesktopAppearance::changed, &application,
                     [&](std::optional<bool> isLight) { setDesktopTheme(application, isLight); });
    std::unique_ptr<StudioController> studio;
    try {
        studio = std::make_unique<StudioController>();
    } catch (const vs::GlError& e) {
        QMessageBox::critical(nullptr, QApplication::applicationDisplayName(), QString::fromUtf8(e.what()));
        throw;
    }
    const RehearsalKeeper rehearsals(studio->host());
    auto& tools = *new ToolBox(*studio); // the studio owns it
    MainWindow window(*studio, tools);
    const QSize screen = window.screen()->availableSize();
    window.resize(screen.boundedTo(QSize(1440, 900)));
    window.show();
    if (!options.layoutFile.empty()) {
        new LayoutReporter(*studio, tools, window, window.view(), options.layoutFile); // the window owns it
    }
    if (!options.timingsFile.empty()) {
        new LatencyRecorder(application, *studio, window.view(), options.timingsFile); // the studio owns it
    }
    studio->files().limitMemory(options.budgets);
    if (!options.open.volume.empty() || !options.open.session.empty()) {
        studio->files().open(options.open);
    }
    const int code = QApplication::exec();
    if (code == MainWindow::kStartsAgain) {
        decoder.reset();
        startAgain(options); // nothing else is taken down first: with the device lost that might not end
    }
    return code;
}

// Help and version are for terminals without a display too.
void answerWithoutDisplay(int argc, char** argv) {
    const bool asks = std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
        return argument == "--help" || argument == "-h" || argument == "--version" || argument == "-v";
    });
    if (asks) {
        QCoreApplication application(argc, argv);
        QCoreApplication::setApplicationName("volume-studio");
        QCoreApplication::setApplicationVersion(VOLUME_STUDIO_VERSION);
        vs::desktop::speak(application, vs::desktop::Preferences::load().language);
        vs::desktop::parseOptions(application); // prints and ends the program
    }
}

} // namespace

int main(int argc, char** argv) {
    vs::keepFreedMemory();
    using vs::desktop::RehearsalKeeper;
    if (argc >= 4 && argv[1] == std::string_view(RehearsalKeeper::kRehearse)) {
        if (argc == 5 && argv[4] == std::string_view(RehearsalKeeper::kAside)) {
            vs::desktop::standBack();
        }
        return vs::desktop::rehearse(argv[2], argv[3]);
    }
    answerWithoutDisplay(argc, argv);
    vs::desktop::WatchedApplication application(argc, argv);
    // Every place that the pen reports belongs to the stroke; on X11 Qt drops those it has no time for. Set
    // only now, because the platform's plugin sets it while the application is made.
    QApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
    QApplication::setApplicationName("volume-studio");
    QApplication::setApplicationDisplayName("Volume Studio");
    QApplication::setApplicationVersion(VOLUME_STUDIO_VERSION);
    QApplication::setDesktopFileName("volume-studio"); // where the desktop finds name and icon
    QApplication::setWindowIcon(QIcon::fromTheme("volume-studio"));
    std::setlocale(LC_NUMERIC, "C"); // file readers expect points in numbers whatever the person's language
    try {
        return run(application);
    } catch (const vs::UsageError& e) {
        vs::logNotice(e.what());
        return 2;
    } catch (const std::exception& e) {
        vs::logNotice(e.what());
        return 1;
    }
}
