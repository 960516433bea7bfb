// SPDX-License-Identifier: Apache-2.0
#include "studio/json/journal.h"

#include "base/error.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

// Operations whose text is longer (strokes, seeds with their voxels) are never replaced, and need not be
// compared each time; but an absorbing stroke goes on, however many voxels it has.
constexpr std::size_t kMayGoOn = 4096;

// All of it, or none: half a line in the midst would make the journal unreadable.
void writeWhole(int file, const std::string& text, const std::filesystem::path& path) {
    const off_t before = lseek(file, 0, SEEK_END);
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = ::write(file, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            const std::string reason = std::strerror(errno);
            [[maybe_unused]] const int isCut = ftruncate(file, before);
            throw WriteError("{}: the journal cannot be written ({}); save the session, and make room there",
                             path.string(), reason);
        }
        done += std::size_t(count);
    }
}

// With absolute names: it may be read from elsewhere.
Json written(Operation operation) {
    if (auto* labels = std::get_if<LoadLabels>(&operation)) {
        labels->path = std::filesystem::absolute(labels->path);
    }
    return toJson(operation);
}

} // namespace

Journal::Journal(const std::filesystem::path& path, const Session& source) : path_(path) {
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    constexpr int kOwnerOnly = 0600; // names of files can be names of patients
    file_ = Descriptor(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, kOwnerOnly));
    if (file_.number() < 0) {
        throw WriteError("{}: the journal cannot be made ({}); what is done now would be lost in a crash",
                         path.string(), std::strerror(errno));
    }
    flock(file_.number(), LOCK_EX);
    try {
        append({{"volumeStudioJournal", kJournalVersion},
                {"volume", volumeToJson(source, source.volumePath)},
                {"precision", std::stoi(sculpt::kPrecisions[std::size_t(source.precision)])}});
    } catch (const std::exception&) {
        std::filesystem::remove(path, ignored);
        throw;
    }
}

bool Journal::isThere() const {
    struct stat now {};
    return fstat(file_.number(), &now) == 0 && now.st_nlink > 0;
}

void Journal::follow(const std::vector<Operation>& log) {
    written_ = std::min(written_, log.size());
    const bool hasGoneOn = written_ > 0 && !last_.empty() && written(log[written_ - 1]).dump() != last_;
    for (written_ -= hasGoneOn ? 1 : 0; written_ < log.size(); ++written_) {
        Json json = written(log[written_]);
        const std::string text = json.dump();
        const bool mayGoOn = text.size() < kMayGoOn || std::holds_alternative<Absorb>(log[written_]);
        last_ = mayGoOn ? text : std::string();
        append({{"n", written_}, {"operation", std::move(json)}});
    }
}

void Journal::noteSaved(const std::filesystem::path& session) { append({{"saved", session.string()}}); }

void Journal::append(const Json& line) {
    std::string text;
    try {
        text = line.dump() + "\n";
    } catch (const Json::exception&) {
        throw WriteError("{}: the journal is UTF-8 text, and the name of the volume is not; rename it",
                         path_.string());
    }
    if (!isThere()) {
        throw WriteError("{}: the journal has been removed; what is done now would be lost in a crash",
                         path_.string());
    }
    writeWhole(file_.number(), text, path_);
}

} // namespace vs::studio
