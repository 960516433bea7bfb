// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"
#include "studio/json/session.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace vs::studio {

// The crash journal of an open document: which volume, and every operation as it is applied, one line of JSON
// each. A line is handed to the system at once, so it survives the death of the process (not of the machine:
// nothing is synced). Costs what the operation takes as text: some 0.1 ms for a stroke. While it is open its
// file is locked (flock), so that other programs see that its work is not lost (lost_work.h).
class Journal {
public:
    // Begins one; makes its folder, never writes over a file. `source` says where the volume comes from, by
    // an absolute path; its operations are ignored. Throws WriteError.
    Journal(const std::filesystem::path& path, const Session& source);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    // False when somebody has removed its file: what is written then is lost.
    [[nodiscard]] bool isThere() const;
    // Writes what the document's log has that the journal has not. An operation that goes on (a rewinding, a
    // slider) takes the place of what was written of it. Throws WriteError; then the next call tries again.
    void follow(const std::vector<Operation>& log);
    // All operations so far are in that session file. Throws WriteError.
    void noteSaved(const std::filesystem::path& session);

private:
    void append(const nlohmann::ordered_json& line);

    std::filesystem::path path_;
    Descriptor file_;
    std::size_t written_ = 0; // operations
    std::string last_;        // the text of the last one if it may go on, else empty
};

} // namespace vs::studio
