// SPDX-License-Identifier: Apache-2.0
#include "studio/json/journal_content.h"

#include "base/error.h"
#include "base/input_file.h"
#include "base/json_file.h"
#include "base/lines.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace vs::studio {

namespace {

void readHeader(const JsonReader& reader, Session& session) {
    reader.allow({"volumeStudioJournal", "volume", "precision"});
    (void)reader.member("volumeStudioJournal").integerBetween(1, kJournalVersion);
    readVolume(reader.member("volume"), session);
    session.precision = readPrecision(reader.member("precision"));
}

// One line after the first: an operation, or that the session was saved.
void readEntry(const JsonReader& reader, const std::string& where, JournalContent& content) {
    auto& operations = content.session.operations;
    if (reader.json().is_object() && reader.json().contains("saved")) {
        reader.allow({"saved"});
        content.savedAs = reader.member("saved").fileName();
        content.saved = operations.size();
        return;
    }
    reader.allow({"n", "operation"});
    const auto n = std::size_t(reader.member("n").integerBetween(0, long(operations.size())));
    auto operation = operationFromJson(reader.member("operation").json(), where);
    operations.resize(n); // of one that went on, the last line counts
    content.saved = std::min(content.saved, n);
    operations.push_back(std::move(operation));
}

} // namespace

std::size_t JournalContent::unsavedEdits() const {
    const auto& operations = session.operations;
    return std::size_t(std::count_if(operations.begin() + std::ptrdiff_t(saved), operations.end(), isEdit));
}

JournalContent readJournal(const std::filesystem::path& path) {
    std::ifstream in(whyNoFile(path).empty() ? path : std::filesystem::path(), std::ios::binary);
    JournalContent content;
    int number = 0;
    int leftOut = 0;
    // A line without its end was being written when the process died.
    for (std::string line; nextLine(in, line, path) && !in.eof();) {
        const std::string where = fmt::format("{}: line {}", path.string(), ++number);
        try {
            const auto json = parseJson(line, where, "a line of a journal", "doc/session.md");
            const JsonReader reader(json, where);
            number == 1 ? readHeader(reader, content.session) : readEntry(reader, where, content);
        } catch (const SessionError& error) {
            if (number == 1) {
                throw;
            }
            // What follows and needs it is refused for its number, which is too high then.
            content.leftOut = leftOut++ == 0 ? error.what() : content.leftOut;
        }
    }
    if (number == 0) {
        throw SessionError("{}: it is empty or cannot be read; the journal can only be discarded",
                           path.string());
    }
    if (leftOut > 0) {
        content.leftOut += leftOut == 1
                               ? "; this line is left out"
                               : fmt::format("; {} lines are left out, with those that need it", leftOut);
    }
    return content;
}

} // namespace vs::studio
