// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"
#include "arguments/storage_argument.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/progress.h"
#include "sessions/replay.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/log.h"
#include "base/timer.h"
#include "gl/context.h"
#include "gl/limits.h"
#include "studio/json/session_state.h"
#include "volume/reading/read_volume.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace vs::cli {

namespace {

struct RunOptions {
    std::string session;
    std::string output;
    std::string picture;    // of the last view; empty: none
    std::string size;       // of that
    std::string saved;      // session file to write, with state; empty: none
    bool fromState = false; // nothing is done again
    StorageArgument storage;
    VolumeArgument volume; // instead of the session's own, as far as given
};

using Json = nlohmann::ordered_json;

Json entryOf(const studio::Outcome& outcome, std::size_t index) {
    Json entry{{"operation", index + 1},
               {"name", outcome.name},
               {"milliseconds", outcome.milliseconds},
               {"voxels", outcome.voxelsTouched}};
    if (!outcome.message.isEmpty()) {
        entry["message"] = outcome.message.english();
    }
    return entry;
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw WriteError("{}: cannot be made ({}); choose a folder that can be written to", folder.string(),
                         error ? error.message() : "a file of that name exists");
    }
}

// The folders of all files that the session writes, before any work is done.
void makeFolders(const std::filesystem::path& folder, const std::vector<studio::Operation>& operations) {
    makeFolder(folder);
    for (const studio::Operation& operation : operations) {
        std::visit(
            [&folder](const auto& op) {
                if constexpr (requires { op.file; }) {
                    makeFolder((folder / op.file).parent_path());
                }
            },
            operation);
    }
}

// The most memory that this process has had at any time, in bytes.
std::size_t peakOfProcess() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
}

// What a run has done so far, on disk at any moment: an older report must not be taken for this run's.
class Report {
public:
    Report(const std::filesystem::path& folder, Json head)
        : file_(folder / "report.json"), json_(std::move(head)) {
        json_["complete"] = false;
        json_["operations"] = Json::array();
        write();
    }

    void add(const studio::Outcome& outcome) {
        json_["operations"].push_back(entryOf(outcome, json_["operations"].size()));
    }
    void complete(const studio::UndoStatistics& undo) {
        json_["undo"] = {{"steps", undo.steps},
                         {"bytesInMemory", undo.bytesInMemory},
                         {"bytesInFile", undo.bytesInFile},
                         {"changedVoxels", undo.changedVoxels},
                         {"bytesPerChangedVoxel", undo.bytesPerChangedVoxel()}};
        json_["memory"] = {{"devicePeakBytes", gl::deviceBytes().peak}, {"hostPeakBytes", peakOfProcess()}};
        json_["complete"] = true;
        write();
    }
    void fail(const std::string& error) {
        json_["error"] = error;
        try {
            write();
        } catch (const WriteError& second) { // the first error is the one to tell
            logNotice(second.what());
        }
    }

private:
    void write() const {
        // File names need not be UTF-8, JSON must be.
        writeFileAtomically(file_, json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    }

    std::filesystem::path file_;
    Json json_;
};

void replay(const studio::Session& session, const RunOptions& options, const gl::Context& context,
            studio::Document& document, Report& report) {
    Progress progress("replaying", session.operations.size());
    for (std::size_t i = 0; i < session.operations.size(); ++i) {
        report.add(replayOperation(session, options.session, i, document, context, options.output));
        progress.advance();
    }
}

studio::SavePicture lastPicture(const RunOptions& options) {
    checkPictureName(options.picture);
    if (std::filesystem::path(options.picture).has_parent_path()) {
        throw UsageError("{}: --picture is a name in the output folder; give one without folders",
                         options.picture);
    }
    studio::SavePicture picture;
    picture.file = options.picture;
    picture.size = options.size.empty() ? picture.size : parseSize(options.size);
    return picture;
}

// Where the volume that was used comes from.
studio::Session sourceOf(const studio::Session& session, const RunOptions& options,
                         const studio::Document& document, const volume::ReadOptions& used) {
    studio::Session source = session;
    if (!session.isMade()) {
        source.volumePath = volume::absolutePath(document.volume().path);
    }
    if (!used.raw) {
        source.rawLayout.clear();
    } else {
        source.rawLayout = options.volume.rawLayout.value_or(source.rawLayout);
    }
    source.series = used.series.value_or("");
    source.frame = used.frame;
    source.level = used.level;
    source.channel = used.channel;
    return source;
}

void save(const studio::Session& session, const RunOptions& options, const studio::Document& document,
          const volume::ReadOptions& used) {
    const Timer timer;
    std::vector<std::string> notices;
    studio::saveDocument(options.saved, document, sourceOf(session, options, document, used), notices);
    for (const auto& notice : notices) {
        logNotice(notice);
    }
    fmt::print("saved {} in {:.0f} ms\n", options.saved, timer.milliseconds());
}

// As it was when it was saved.
std::unique_ptr<studio::Document> fromState(const studio::Session& session, const RunOptions& options,
                                            volume::Volume volume, bool cutsFinest) {
    std::vector<std::string> notices;
    auto state = studio::loadState(options.session, session, volume, notices, cutsFinest);
    if (!state) {
        throw SessionError("{}", notices.empty() ? options.session +
                                                       ": has no state to be opened from; leave --state out, "
                                                       "and it is replayed"
                                                 : notices.front());
    }
    return std::make_unique<studio::Document>(std::move(volume), std::move(*state));
}

void runSession(const RunOptions& options) {
    studio::Session session = studio::loadSession(options.session);
    const auto last = options.picture.empty() ? std::nullopt : std::optional(lastPicture(options));
    const std::filesystem::path folder = options.output;
    const Timer loading;
    // First: how much is worked on follows what its device has.
    const auto context = gl::Context::createHeadless();
    auto [volume, finer, notices, used] =
        loadSessionScan(session, options.session, options.volume, options.storage);
    const std::string volumeName = volume.name;
    const bool cutsFinest = finer && finer->areFinerThan(volume);
    const auto document = options.fromState
                              ? fromState(session, options, std::move(volume), cutsFinest)
                              : std::make_unique<studio::Document>(std::move(volume), session.precision);
    showFiner(*document, finer, notices);
    gl::Context::finish();
    makeFolders(folder, session.operations);
    Report report(folder, {{"session", options.session},
                           {"volume", volumeName},
                           {"device", context.device().renderer},
                           {"level", used.level.value_or(0)},
                           {"storage", document->detail() != nullptr ? "bricks" : "dense"},
                           {"loadMilliseconds", loading.milliseconds()},
                           {"notices", notices}});
    try {
        if (!options.fromState) {
            replay(session, options, context, *document, report);
        }
        if (!options.saved.empty()) {
            save(session, options, *document, used);
        }
        if (last) {
            report.add(document->apply(*last, folder));
        }
        gl::Context::finish();
        context.requireNoErrors();
    } catch (const std::exception& error) {
        report.fail(error.what());
        throw;
    }
    tellFailures(*document);
    report.complete(document->history().statistics());
    fmt::print("{}: {} operations on {}{}; results in {}\n", options.session,
               session.operations.size() + (last ? 1 : 0), volumeName,
               options.fromState ? ", from the state" : "", folder.string());
    if (!last && std::none_of(session.operations.begin(), session.operations.end(), studio::isOutput)) {
        fmt::print("the session asks for no picture; --picture last.png writes one of its last view\n");
    }
}

} // namespace

void addRunCommand(CLI::App& app) {
    auto* command = app.add_subcommand("run", "Replay a session and write what it asks for, and report.json");
    auto options = std::make_shared<RunOptions>();
    command->add_option("session", options->session, "Session file (JSON, see doc/session.md)")->required();
    command->add_option("-o,--output", options->output, "Folder for pictures, label maps and report.json")
        ->required();
    auto* picture = command->add_option("--picture", options->picture,
                                        "Write the last view too, as PNG, by this name in that folder");
    command->add_option("--size", options->size, "Size of that picture, WxH; 1230x870 without")
        ->needs(picture);
    command->add_option("--save", options->saved,
                        "Save the session there, with the state that it leads to, so that it opens at once");
    command->add_flag("--state", options->fromState,
                      "Open it from the state that was saved with it: nothing is done again, and files that "
                      "its operations write are not written");
    command->add_option("--volume", options->volume.path, "Use this volume instead of the session's own");
    addReadOptions(*command, options->volume);
    addStorageOptions(*command, options->storage);
    command->callback([options] { runSession(*options); });
}

} // namespace vs::cli
