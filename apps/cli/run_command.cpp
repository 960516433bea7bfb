// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "progress.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/timer.h"
#include "gl/context.h"
#include "studio/session.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace vs::cli {

namespace {

struct RunOptions {
    std::string session;
    std::string output;
    std::string volume;
};

using Json = nlohmann::ordered_json;

Json entryOf(const studio::Outcome& outcome, std::size_t index) {
    Json entry{{"operation", index + 1},
               {"name", outcome.name},
               {"milliseconds", outcome.milliseconds},
               {"voxels", outcome.voxelsTouched}};
    if (!outcome.message.empty()) {
        entry["message"] = outcome.message;
    }
    return entry;
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder)) {
        throw WriteError("{}: cannot be made ({}); choose a folder that can be written to", folder.string(),
                         error ? error.message() : "a file of that name exists");
    }
}

void runSession(const RunOptions& options) {
    const studio::Session session = studio::loadSession(options.session);
    const std::filesystem::path folder = options.output;
    makeFolder(folder);
    std::vector<std::string> notices;
    const Timer loading;
    auto volume = studio::openVolume(
        session, options.session,
        options.volume.empty() ? std::nullopt : std::optional<std::filesystem::path>(options.volume),
        notices);
    for (const auto& notice : notices) {
        logNotice(notice);
    }
    const auto context = gl::Context::createHeadless();
    const std::string volumeName = volume.name;
    studio::Document document(std::move(volume));
    gl::Context::finish();
    Json report{{"session", options.session},
                {"volume", volumeName},
                {"device", context.device().renderer},
                {"loadMilliseconds", loading.milliseconds()},
                {"notices", notices},
                {"operations", Json::array()}};

    Progress progress("replaying", session.operations.size());
    for (std::size_t i = 0; i < session.operations.size(); ++i) {
        try {
            report["operations"].push_back(entryOf(document.apply(session.operations[i], folder), i));
        } catch (const Error& error) {
            throw SessionError("{}: operation {} ({}): {}", options.session, i + 1,
                               name(session.operations[i]), error.what());
        }
        progress.advance();
    }
    writeFileAtomically(folder / "report.json", report.dump(2) + "\n");
    fmt::print("{}: {} operations on {}; results in {}\n", options.session, session.operations.size(),
               volumeName, folder.string());
}

} // namespace

void addRunCommand(CLI::App& app) {
    auto* command = app.add_subcommand("run", "Replay a session and write what it asks for, and report.json");
    auto options = std::make_shared<RunOptions>();
    command->add_option("session", options->session, "Session file (JSON, see doc/session.md)")->required();
    command->add_option("-o,--output", options->output, "Folder for pictures, label maps and report.json")
        ->required();
    command->add_option("--volume", options->volume, "Use this volume instead of the session's own");
    command->callback([options] { runSession(*options); });
}

} // namespace vs::cli
