// SPDX-License-Identifier: Apache-2.0
// The line of hints: what it says in every state of every tool.
#include "hint_states.h"
#include "window/hint_line.h"

#include "model/hand/tool.h"

#include <gtest/gtest.h>

#include <fstream>

namespace vs::desktop {
namespace {

TEST(Hints, SayWhatHappensNext) {
    auto& w = StudioWindow::instance();
    std::ofstream out(StudioWindow::folder / "hints.txt");
    const auto look = [&](const std::string& state) {
        const QString hint = w.part<QLabel>("hint").text();
        EXPECT_EQ(hint, w.studio().hand().tool().hint()) << state;
        out << state << " | " << hint.toStdString() << "\n";
    };
    forEachSketchHint(w, look);
    forEachClickHint(w, look);
}

TEST(Texts, HintsFitTheirLine) {
    auto& w = StudioWindow::instance();
    auto& line = w.part<QLabel>("hint");
    const auto look = [&](const std::string& state) {
        line.setWordWrap(false); // a line that has become narrow meanwhile asks for no room
        const int width = line.sizeHint().width();
        EXPECT_LE(width, HintLine::kRoomForHints) << state << ": " << line.text().toStdString();
    };
    forEachSketchHint(w, look);
    forEachClickHint(w, look);
}

} // namespace
} // namespace vs::desktop
