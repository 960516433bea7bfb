// SPDX-License-Identifier: Apache-2.0
#include "studio/json/journal.h"

#include "base/error.h"
#include "base/input_file.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace vs::studio {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kVersion = 1;
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

Json textOrFail(const std::string& line, const std::string& where) {
    Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) {
        throw SessionError("{}: it is no JSON; the journal is damaged, and can only be discarded", where);
    }
    return json;
}

void readHeader(const Json& json, const std::string& where, Session& session) {
    const JsonReader reader(json, where);
    reader.allow({"volumeStudioJournal", "volume", "precision"});
    (void)reader.member("volumeStudioJournal").integerBetween(1, kVersion);
    readVolume(reader.member("volume"), session);
    session.precision = readPrecision(reader.member("precision"));
}

// One line after the first: an operation, or that the session was saved.
void readEntry(const Json& json, const std::string& where, JournalContent& content) {
    const JsonReader reader(json, where);
    auto& operations = content.session.operations;
    if (json.is_object() && json.contains("saved")) {
        reader.allow({"saved"});
        content.savedAs = reader.member("saved").fileName();
        content.saved = operations.size();
        return;
    }
    reader.allow({"n", "operation"});
    const auto n = std::size_t(reader.member("n").integerBetween(0, long(operations.size())));
    operations.resize(n); // of one that went on, the last line counts
    content.saved = std::min(content.saved, n);
    operations.push_back(operationFromJson(reader.member("operation").json(), where));
}

} // namespace

Journal::Journal(const std::filesystem::path& path, const Session& source) : path_(path) {
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    constexpr int kOwnerOnly = 0600; // names of files can be names of patients
    file_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, kOwnerOnly);
    if (file_ < 0) {
        throw WriteError("{}: the journal cannot be made ({}); what is done now would be lost in a crash",
                         path.string(), std::strerror(errno));
    }
    append({{"volumeStudioJournal", kVersion},
            {"volume", volumeToJson(source, source.volumePath)},
            {"precision", std::stoi(sculpt::kPrecisions[std::size_t(source.precision)])}});
}

Journal::~Journal() { close(file_); }

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
    writeWhole(file_, text, path_);
}

std::size_t JournalContent::unsavedEdits() const {
    const auto& operations = session.operations;
    return std::size_t(std::count_if(operations.begin() + std::ptrdiff_t(saved), operations.end(), isEdit));
}

JournalContent readJournal(const std::filesystem::path& path) {
    std::ifstream in(whyNoFile(path).empty() ? path : std::filesystem::path(), std::ios::binary);
    JournalContent content;
    int number = 0;
    // A line without its end was being written when the process died.
    for (std::string line; std::getline(in, line) && !in.eof();) {
        const std::string where = fmt::format("{}: line {}", path.string(), ++number);
        const Json json = textOrFail(line, where);
        number == 1 ? readHeader(json, where, content.session) : readEntry(json, where, content);
    }
    if (number == 0) {
        throw SessionError("{}: it is empty or cannot be read; the journal can only be discarded",
                           path.string());
    }
    return content;
}

} // namespace vs::studio
