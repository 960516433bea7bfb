// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/session.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vs::studio {

// The crash journal of an open document: which volume, and every operation as it is applied, one line of JSON
// each. A line is handed to the system at once, so it survives the death of the process (not of the machine:
// nothing is synced). Costs what the operation takes as text: some 0.1 ms for a stroke.
class Journal {
public:
    // Begins one; makes its folder, never writes over a file. `source` says where the volume comes from, by
    // an absolute path; its operations are ignored. Throws WriteError.
    Journal(const std::filesystem::path& path, const Session& source);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    // Writes what the document's log has that the journal has not. An operation that goes on (a rewinding, a
    // slider) takes the place of what was written of it. Throws WriteError; then the next call tries again.
    void follow(const std::vector<Operation>& log);
    // All operations so far are in that session file. Throws WriteError.
    void noteSaved(const std::filesystem::path& session);

private:
    void append(const nlohmann::ordered_json& line);

    std::filesystem::path path_;
    int file_ = -1;
    std::size_t written_ = 0; // operations
    std::string last_;        // the text of the last one if it may go on, else empty
};

// What a journal tells of a document that was not closed.
struct JournalContent {
    Session session;
    std::size_t saved = 0;         // so many of the operations are in a session file
    std::filesystem::path savedAs; // the last one; empty: none

    // Edits that no session file holds.
    [[nodiscard]] std::size_t unsavedEdits() const;
};

// Reads a journal. A last line that is not whole is left out: the process died while writing it. Throws
// SessionError naming file and line.
JournalContent readJournal(const std::filesystem::path& path);

} // namespace vs::studio
