// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phantom/recipe.h"
#include "studio/document/document.h"
#include "volume/io/read.h"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace vs::studio {

// A session file: which volume, and what was done to it. doc/session.md describes it, doc/session.schema.json
// is its schema.
struct Session {
    static constexpr int kVersion = 2; // 1 had no state

    // Voxels of a volume that a session makes: few words must not ask for more than a machine has.
    static constexpr std::int64_t kMostMadeVoxels = 1 << 27; // 512 x 512 x 512

    // A volume made from nothing: every voxel 1. What is cut from it is built, and seen in probe view.
    struct Block {
        static constexpr int kMostVoxels = 1024; // along each axis
        static constexpr Range kSpacingMm{1e-3, 1e3};

        glm::ivec3 dims{128};
        glm::dvec3 spacingMm{1};
    };
    int version = kVersion; // of the file that it was read from
    std::optional<Block> block;
    std::optional<phantom::Recipe> phantom; // a volume that is made
    // With neither the volume is a file:
    std::filesystem::path volumePath; // absolute, or relative to the session file
    std::string volumeChecksum;       // empty: not checked
    std::string rawLayout;            // set for headerless files
    std::string series;               // set when a DICOM series was chosen
    std::optional<int> frame;
    std::optional<int> level;                                // of a store of OME-Zarr
    std::optional<int> channel;                              // of a store or a stack
    sculpt::Precision precision = sculpt::Precision::Bits16; // of the sculpture
    std::vector<Operation> operations;
    // The checksum of the state that was saved beside the file (studio/json/session_state.h), and that of the
    // operations as the file has them. Empty: there is none.
    std::string stateChecksum = {};
    std::string operationsChecksum = {};

    [[nodiscard]] bool isMade() const { return block || phantom; } // no file has the volume
};

// Throws SessionError naming file, operation and member, what is wrong and what would be right.
Session loadSession(const std::filesystem::path& path);
// Reads a session from a text that is at hand. `path` is how it is called in messages, and what the names of
// files are relative to.
Session sessionFromText(std::string_view text, const std::filesystem::path& path);

// The checksum of a session's operations as a file at `path` would have them.
std::string operationsChecksum(const std::filesystem::path& path, const Session& session);

// Atomic. The volume's path is stored relative to the file when it lies below its folder. Throws WriteError,
// also for names that are not UTF-8.
void saveSession(const std::filesystem::path& path, const Session& session);

// The session of a document as it is now: its log, ended by its current view. `source` says where the volume
// came from (path, layout, series, frame, level, channel); its operations are ignored.
Session sessionOf(const Document& document, const Session& source);

// A session's volume is not where the session says, and was not found elsewhere.
class MovedVolume : public SessionError {
public:
    MovedVolume(const std::string& message, std::filesystem::path wanted)
        : SessionError(message), wanted_(std::move(wanted)) {}
    // Where the session says that it is.
    [[nodiscard]] const std::filesystem::path& wanted() const { return wanted_; }

private:
    std::filesystem::path wanted_;
};

// Opens the session's volume (or `replacement` instead, with a notice if its content differs). One that is
// not where the session says is looked for by its name beside the session, then, if the session has a
// checksum, in `folders`; what has another one is not taken for it. A notice says where it was found; throws
// MovedVolume where it was not. `used`, if given, is what it was read with. Notices are appended. What
// `overrides` sets takes the place of the session's layout, series and frame, which apply to a replacement
// only where they fit it: the layout if it is headerless too, series and frame if it has them.
volume::Volume openVolume(const Session& session, const std::filesystem::path& sessionPath,
                          const std::optional<std::filesystem::path>& replacement,
                          std::vector<std::string>& notices, const volume::ReadOptions& overrides = {},
                          const std::vector<std::filesystem::path>& folders = {},
                          volume::ReadOptions* used = nullptr);

// Where the session's volume, or the replacement, lies; of a volume that is made, nowhere.
std::filesystem::path volumePathOf(const Session& session, const std::filesystem::path& sessionPath,
                                   const std::optional<std::filesystem::path>& replacement);

// Where the session's volume, or the replacement, is a store and was read at another level than the session
// was made on: has its operations speak of that level, for a look at what they do, and says so in a notice.
// `growsFinest`: segments grow at the finest level whatever is worked on; else, and where that is the finest
// itself, voxels of the finest level become voxels of the one that is worked on.
// Returns whether it is another session now. Throws ReadError and Error.
bool goToLevel(Session& session, const std::filesystem::path& sessionPath,
               const std::optional<std::filesystem::path>& replacement, const volume::ReadOptions& used,
               bool growsFinest, std::vector<std::string>& notices);

} // namespace vs::studio
