// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/session.h"

#include <filesystem>
#include <string>

namespace vs::studio {

// What a journal tells of a document that was not closed.
struct JournalContent {
    Session session;
    std::size_t saved = 0;         // so many of the operations are in a session file
    std::filesystem::path savedAs; // the last one; empty: none
    std::string leftOut;           // what of the journal could not be read, and why; empty: nothing

    // Edits that no session file holds.
    [[nodiscard]] std::size_t unsavedEdits() const;
};

// Reads a journal. A last line that is not whole is left out: the process died while writing it. A line that
// is damaged is left out too, with all after it that needs it; `leftOut` says so. Throws SessionError naming
// file and line when not even the first, which says what volume it is of, can be read.
JournalContent readJournal(const std::filesystem::path& path);

} // namespace vs::studio
