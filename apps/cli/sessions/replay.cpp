// SPDX-License-Identifier: Apache-2.0
#include "sessions/replay.h"

#include "reports/progress.h"

#include "base/error.h"
#include "base/log.h"
#include "studio/json/session_state.h"

#include <fmt/format.h>

#include <optional>
#include <span>

namespace vs::cli {

volume::Volume loadSessionVolume(const studio::Session& session, const std::string& sessionPath,
                                 const VolumeArgument& instead, std::vector<std::string>& notices,
                                 volume::ReadOptions* used) {
    const auto replacement =
        instead.path.empty() ? std::nullopt : std::optional<std::filesystem::path>(instead.path);
    auto volume = [&] {
        const Activity activity("reading the volume of " + sessionPath);
        return studio::openVolume(session, sessionPath, replacement, notices, readOptions(instead), {}, used);
    }();
    for (const auto& notice : notices) {
        logNotice(notice);
    }
    return volume;
}

studio::Outcome replayOperation(const studio::Session& session, const std::string& sessionPath,
                                std::size_t index, studio::Document& document, const gl::Context& context,
                                const std::filesystem::path& outputFolder) {
    const studio::Operation& operation = session.operations[index];
    try {
        auto outcome =
            document.apply(operation, outputFolder, std::span(session.operations).subspan(index + 1));
        context.requireNoErrors();
        const bool isDrawn = studio::cuts(operation) || std::holds_alternative<studio::Seed>(operation);
        if (isDrawn && outcome.voxelsTouched == 0) {
            logNotice(
                fmt::format("operation {} ({}): {}", index + 1, outcome.name, outcome.message.english()));
        }
        return outcome;
    } catch (const std::exception& error) {
        throw SessionError("{}: operation {} ({}): {}", sessionPath, index + 1, name(operation),
                           error.what());
    }
}

SessionScan loadSessionScan(studio::Session& session, const std::string& sessionPath,
                            const VolumeArgument& instead, const StorageArgument& storage) {
    SessionScan scan;
    const auto replacement =
        instead.path.empty() ? std::nullopt : std::optional<std::filesystem::path>(instead.path);
    VolumeArgument wanted = instead;
    const bool isDense = storage.kind() == studio::Storage::Dense;
    if (!wanted.level && !session.level && !session.isMade()) {
        volume::ReadOptions options = readOptions(instead);
        options.channel = options.channel ? options.channel : session.channel;
        options.frame = options.frame ? options.frame : session.frame;
        wanted.level = studio::levelInReach(studio::volumePathOf(session, sessionPath, replacement), options,
                                            isDense ? studio::MemoryBudgets() : storage.budgets());
    }
    scan.volume = loadSessionVolume(session, sessionPath, wanted, scan.notices, &scan.used);
    const std::size_t told = scan.notices.size();
    studio::goToLevel(session, sessionPath, replacement, scan.used, !isDense, scan.notices);
    for (std::size_t n = told; n < scan.notices.size(); ++n) {
        logNotice(scan.notices[n]);
    }
    scan.finer = findFiner(scan.volume, scan.used, storage, scan.notices);
    return scan;
}

namespace {

void replayEdits(const studio::Session& session, const std::string& sessionPath, studio::Document& document,
                 const gl::Context& context) {
    Progress progress("replaying", session.operations.size());
    for (std::size_t i = 0; i < session.operations.size(); ++i) {
        if (studio::isOutput(session.operations[i])) {
            document.logOutput(session.operations[i]);
        } else {
            replayOperation(session, sessionPath, i, document, context, {});
        }
        progress.advance();
    }
}

} // namespace

std::unique_ptr<studio::Document> openDocument(const studio::Session& session, const std::string& sessionPath,
                                               SessionScan scan, const gl::Context& context) {
    std::vector<std::string> notices;
    auto state = studio::loadState(sessionPath, session, scan.volume, notices,
                                   scan.finer && scan.finer->areFinerThan(scan.volume));
    for (const auto& notice : notices) {
        logNotice(notice);
    }
    if (state) {
        try {
            auto document = std::make_unique<studio::Document>(std::move(scan.volume), std::move(*state));
            showFiner(*document, scan.finer, scan.notices);
            return document;
        } catch (const Error& error) {
            throw SessionError("{}: its state cannot be used ({}); remove {}, and everything is done again",
                               sessionPath, error.what(), studio::statePath(sessionPath).string());
        }
    }
    auto document = std::make_unique<studio::Document>(std::move(scan.volume), session.precision);
    showFiner(*document, scan.finer, scan.notices);
    replayEdits(session, sessionPath, *document, context);
    return document;
}

} // namespace vs::cli
