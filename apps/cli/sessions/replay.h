// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments/storage_argument.h"
#include "arguments/volume_argument.h"

#include "gl/context.h"
#include "studio/document/document.h"
#include "studio/json/session.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vs::cli {

// The session's volume, or what `instead` names, read as far as given as it says. Prints the notices and
// appends them; `used`, if given, is what it was read with. Throws as studio::openVolume does.
volume::Volume loadSessionVolume(const studio::Session& session, const std::string& sessionPath,
                                 const VolumeArgument& instead, std::vector<std::string>& notices,
                                 volume::ReadOptions* used = nullptr);

// Applies operation `index` of a session and prints a notice if a stroke met nothing. Throws SessionError
// naming file and operation, also for errors that OpenGL reports.
studio::Outcome replayOperation(const studio::Session& session, const std::string& sessionPath,
                                std::size_t index, studio::Document& document, const gl::Context& context,
                                const std::filesystem::path& outputFolder);

// A session's volume, and levels of it that are finer.
struct SessionScan {
    volume::Volume volume;
    std::optional<studio::FinerLevels> finer;
    std::vector<std::string> notices;
    volume::ReadOptions used; // what it was read with
};
// Reads them as loadSessionVolume() and findFiner() do. A session that was made on another level speaks of
// this one afterwards.
SessionScan loadSessionScan(studio::Session& session, const std::string& sessionPath,
                            const VolumeArgument& instead, const StorageArgument& storage);

// The document of a session: from the state that was saved with it, or, if there is none that fits, by doing
// all of its operations again but those that write files.
std::unique_ptr<studio::Document> openDocument(const studio::Session& session, const std::string& sessionPath,
                                               SessionScan scan, const gl::Context& context);

} // namespace vs::cli
