// SPDX-License-Identifier: Apache-2.0
#include "studio/json/session_state.h"

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/value_json.h"
#include "studio/json/kept_json.h"
#include "studio/json/state_json.h"
#include "studio/state/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace vs::studio {

namespace {

// A new state is written here, until the session that names it is there too.
std::filesystem::path newStatePath(const std::filesystem::path& session) {
    return statePath(session).concat(".new");
}

// Writes the state of a session. Returns its checksum.
std::string writeState(const std::filesystem::path& session, const DocumentState& state,
                       const Json& belongsTo) {
    std::string checksum;
    writeAtomically(newStatePath(session), [&](const std::filesystem::path& temporary) {
        StateWriter file(temporary);
        Json contents = stored(file, state);
        contents["session"] = belongsTo;
        checksum = file.finish(contents);
    });
    return checksum;
}

void removeStates(const std::filesystem::path& session) {
    std::error_code ignored;
    std::filesystem::remove(statePath(session), ignored);
    std::filesystem::remove(newStatePath(session), ignored);
}

// Which session a state belongs to, and where its file had the voxels: corrections of that are in the state.
Json identityOf(const Session& session, const std::string& operations,
                const volume::GridGeometry& geometryInFile) {
    return {{"volume", session.volumeChecksum},
            {"geometry", stored(geometryInFile)},
            {"precision", sculpt::kPrecisions[std::size_t(session.precision)]},
            {"operations", operations}};
}

// A program that was killed after a session was written and before its state had its name left that as new.
void settle(const std::filesystem::path& session) {
    std::error_code ignored;
    const auto left = newStatePath(session);
    if (!std::filesystem::is_regular_file(left, ignored)) {
        return;
    }
    try {
        if (StateReader(left).checksum() == loadSession(session).stateChecksum) {
            std::filesystem::rename(left, statePath(session), ignored);
        }
    } catch (const Error&) { // it belongs to nothing
    }
}

// The state with the session's checksum, wherever a killed program has left it.
std::optional<StateReader> findState(const std::filesystem::path& path, const Session& session,
                                     std::vector<std::string>& notices) {
    std::string trouble = fmt::format("{} is not there", statePath(path).string());
    for (const auto& candidate : {statePath(path), newStatePath(path)}) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(candidate, ignored)) {
            continue;
        }
        try {
            StateReader file(candidate);
            if (file.checksum() == session.stateChecksum) {
                return file;
            }
            trouble = fmt::format("{} is not the one that was saved with it", candidate.string());
        } catch (const Error& error) {
            trouble = error.what();
        }
    }
    notices.push_back(
        fmt::format("{}: its state cannot be used ({}); everything is done again", path.string(), trouble));
    return {};
}

} // namespace

std::filesystem::path statePath(const std::filesystem::path& session) {
    std::error_code error;
    const auto target = std::filesystem::weakly_canonical(session, error);
    return (error ? session : target).string() + ".state";
}

void saveDocument(const std::filesystem::path& path, const Document& document, const Session& source,
                  std::vector<std::string>& notices) {
    Session session = sessionOf(document, source);
    const std::filesystem::path target = outputFile(path);
    settle(target);
    // What was done to a view alone is done again at once.
    // So is what was cut, or has grown, at a finer level than the one that is worked on: states have no room
    // for it.
    const sculpt::FineSculpture* finer = document.sculpture().finer();
    const bool hasEdits = (document.history().canUndo() || document.history().canRedo()) &&
                          (finer == nullptr || finer->version() == 0) &&
                          document.region().finest() == nullptr;
    try {
        if (hasEdits) {
            const Json identity =
                identityOf(session, operationsChecksum(path, session), document.geometryInFile());
            session.stateChecksum = writeState(target, document.state(), identity);
        }
    } catch (const std::exception& error) { // the log is what must not be lost
        notices.push_back(
            fmt::format("{}: saved without its state ({}); it will be done again when it is opened",
                        path.string(), error.what()));
    }
    std::error_code ignored;
    try {
        saveSession(path, session);
    } catch (...) {
        std::filesystem::remove(newStatePath(target), ignored);
        throw;
    }
    if (session.stateChecksum.empty()) {
        removeStates(target);
    } else { // if this fails the new state is found where it is
        std::filesystem::rename(newStatePath(target), statePath(target), ignored);
    }
}

std::optional<DocumentState> loadState(const std::filesystem::path& path, const Session& session,
                                       const volume::Volume& volume, std::vector<std::string>& notices,
                                       bool cutsFinest) {
    if (session.stateChecksum.empty()) {
        return {};
    }
    const auto decline = [&](const std::string& reason) {
        notices.push_back(fmt::format("{}: its state cannot be used ({}); everything is done again",
                                      path.string(), reason));
        return std::optional<DocumentState>();
    };
    Session present = session;
    present.volumeChecksum = volume::checksum(volume);
    auto file = findState(path, session, notices);
    if (!file) {
        return {};
    }
    try {
        if (file->contents().member("session").json() !=
            identityOf(present, session.operationsChecksum, volume.geometry)) {
            return decline("the session, its volume or where that lies has been changed since");
        }
        DocumentState state = readState(*file, volume.geometry.dims);
        const auto hasCut = [](const SavedEdit& edit) { return edit.cut || edit.filledAfter; };
        if (cutsFinest && (!state.cut.isEmpty() || state.growth || !state.filled.materials->empty() ||
                           std::any_of(state.done.begin(), state.done.end(), hasCut) ||
                           std::any_of(state.undone.begin(), state.undone.end(), hasCut))) {
            return decline("tools cut, and segments grow at, a finer level now than the one that it has");
        }
        state.log = session.operations;
        return state;
    } catch (const Error& error) {
        return decline(error.what());
    }
}

} // namespace vs::studio
