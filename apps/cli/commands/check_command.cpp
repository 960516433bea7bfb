// SPDX-License-Identifier: Apache-2.0
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/progress.h"
#include "sessions/replay.h"

#include "base/error.h"
#include "base/timer.h"
#include "gl/context.h"
#include "studio/document/document_content.h"
#include "studio/json/session_state.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace vs::cli {

namespace {

struct CheckOptions {
    std::string session;
    VolumeArgument volume; // instead of the session's own, as far as given
    bool skipsReplay = false;
};

// What a session's state comes to. Throws what is wrong with it.
studio::DocumentContent contentOfState(const CheckOptions& options, const studio::Session& session,
                                       volume::Volume volume) {
    std::vector<std::string> notices;
    const Timer timer;
    auto state = studio::loadState(options.session, session, volume, notices);
    if (!state) {
        throw SessionError("{}", notices.front());
    }
    const studio::Document document(std::move(volume), std::move(*state));
    auto content = studio::contentOf(document);
    fmt::print("its state is whole and fits: {} steps to undo, {} to redo; read in {:.0f} ms\n",
               content.stepsDone, content.stepsUndone, timer.milliseconds());
    return content;
}

studio::DocumentContent contentOfReplay(const CheckOptions& options, const studio::Session& session,
                                        SessionScan scan, const gl::Context& context) {
    const Timer timer;
    studio::Session log = session; // all that is known without the state
    log.stateChecksum.clear();
    const auto document = openDocument(log, options.session, std::move(scan), context);
    fmt::print("its {} operations can be done again: {:.1f} s\n", session.operations.size(),
               timer.milliseconds() / 1000);
    return studio::contentOf(*document);
}

void check(const CheckOptions& options) {
    studio::Session session = studio::loadSession(options.session);
    fmt::print("{}: session version {}, {} operations{}\n", options.session, session.version,
               session.operations.size(), session.stateChecksum.empty() ? ", no state" : "");
    // First: how much is worked on follows what its device has.
    const auto context = gl::Context::createHeadless();
    SessionScan scan = loadSessionScan(session, options.session, options.volume, {});
    fmt::print("its volume is there: {}\n", scan.volume.name);
    std::optional<studio::DocumentContent> saved;
    if (!session.stateChecksum.empty()) {
        saved = contentOfState(options, session, scan.volume);
    }
    if (options.skipsReplay) {
        return;
    }
    const auto replayed = contentOfReplay(options, session, std::move(scan), context);
    context.requireNoErrors();
    if (!saved) {
        return;
    }
    const auto found = studio::differences(*saved, replayed, "the state", "the replay");
    for (const std::string& difference : found) {
        fmt::print("{}\n", difference);
    }
    if (!found.empty()) {
        throw SessionError(
            "{}: its state and its replay differ, as said above; the state is what was saved, and "
            "another device may cut a little differently",
            options.session);
    }
    fmt::print("state and replay are equal, to the byte\n");
}

} // namespace

void addCheckCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "check", "Say whether a session is whole, and whether its state is what its operations lead to");
    auto options = std::make_shared<CheckOptions>();
    command->add_option("session", options->session, "Session file (JSON, see doc/session.md)")->required();
    command->add_flag("--no-replay", options->skipsReplay, "Look at the files only; do nothing again");
    command->add_option("--volume", options->volume.path, "Use this volume instead of the session's own");
    addReadOptions(*command, options->volume);
    command->callback([options] { check(*options); });
}

} // namespace vs::cli
