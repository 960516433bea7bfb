// SPDX-License-Identifier: Apache-2.0
#include "studio/json/lost_work.h"

#include "base/error.h"
#include "base/folder.h"
#include "base/user_folders.h"
#include "studio/json/journal_content.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace vs::studio {

namespace {

std::time_t lastChange(const std::filesystem::path& path) {
    struct stat found {};
    return stat(path.c_str(), &found) == 0 ? found.st_mtime : 0;
}

} // namespace

std::filesystem::path journalFolder() { return stateFolder() / "volume-studio" / "journals"; }

std::optional<HeldJournal> HeldJournal::hold(const std::filesystem::path& journal) {
    Descriptor file(open(journal.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.number() < 0 || flock(file.number(), LOCK_EX | LOCK_NB) != 0) {
        return {};
    }
    // Another program may have removed it between the two.
    struct stat opened {};
    struct stat named {};
    const bool isStillIt = fstat(file.number(), &opened) == 0 && stat(journal.c_str(), &named) == 0 &&
                           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
    return isStillIt ? std::optional(HeldJournal(journal, std::move(file))) : std::nullopt;
}

void HeldJournal::remove() const {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

std::filesystem::path HeldJournal::setAside() const {
    std::filesystem::path aside = path_;
    aside += ".damaged";
    std::error_code error;
    std::filesystem::rename(path_, aside, error);
    if (error) {
        throw WriteError("{}: cannot be renamed ({}); it is offered again at the next start", path_.string(),
                         error.message());
    }
    return aside;
}

LostWork describeJournal(const std::filesystem::path& journal) {
    LostWork lost{journal, lastChange(journal), journal.filename().string()};
    try {
        const auto content = readJournal(journal);
        const auto& volume = content.session.volumePath;
        lost.edits = content.unsavedEdits();
        lost.leftOut = content.leftOut;
        lost.name = content.session.isMade() ? "" : volume.filename().string();
        std::error_code error;
        if (!content.session.isMade() && !std::filesystem::exists(volume, error)) {
            lost.missing = volume;
        }
    } catch (const std::exception& e) {
        lost.problem = e.what();
    }
    return lost;
}

std::vector<LostWork> lostWork() {
    std::vector<LostWork> all;
    std::error_code ignored; // it may be gone by now
    for (const auto& path : entriesOf(journalFolder())) {
        if (path.extension() != ".jsonl" || !std::filesystem::is_regular_file(path, ignored)) {
            continue;
        }
        if (const auto held = HeldJournal::hold(path)) {
            LostWork lost = describeJournal(path);
            const bool isEmpty =
                std::filesystem::file_size(path, ignored) == 0; // killed before its first line
            if (isEmpty || (lost.edits == 0 && lost.leftOut.empty() && lost.problem.empty())) {
                held->remove();
            } else {
                all.push_back(std::move(lost));
            }
        }
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.when > b.when; });
    return all;
}

} // namespace vs::studio
