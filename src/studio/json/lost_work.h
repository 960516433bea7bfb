// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/child_process.h"

#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What runs of the program that did not end well have left behind: journals that nobody writes any more.
namespace vs::studio {

// Where journals lie: in the person's state folder (XDG_STATE_HOME). It need not be there.
std::filesystem::path journalFolder();

// A journal that no running program writes. While this lives no other program takes it in hand: its file is
// locked (flock), which ends with the process, however it ends.
class HeldJournal {
public:
    // Nothing when a running program has it, or when it is not there or cannot be locked.
    static std::optional<HeldJournal> hold(const std::filesystem::path& journal);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void remove() const;
    // All that could be read of it is elsewhere, but not all of it could be read: under another name, which
    // is returned, it is not offered again. Throws WriteError.
    [[nodiscard]] std::filesystem::path setAside() const;

private:
    HeldJournal(std::filesystem::path path, Descriptor file)
        : path_(std::move(path)), file_(std::move(file)) {}

    std::filesystem::path path_;
    Descriptor file_;
};

struct LostWork {
    std::filesystem::path journal;
    std::time_t when = 0; // of the last edit
    std::string name;     // of the volume's file; empty: it was made from nothing
    std::size_t edits = 0;
    std::filesystem::path missing = {}; // the volume's file when it is not there any more
    std::string leftOut = {};           // what of the journal could not be read, and why; empty: nothing
    std::string problem = {};           // why nothing can be recovered; empty: it can
};

// What one journal tells.
LostWork describeJournal(const std::filesystem::path& journal);
// What is in the journal folder, the newest first. Journals of running programs are left out, those without
// unsaved edits removed.
std::vector<LostWork> lostWork();

} // namespace vs::studio
