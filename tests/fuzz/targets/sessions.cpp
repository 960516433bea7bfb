// SPDX-License-Identifier: Apache-2.0
// Files that the program has written, and that anybody may have changed since: sessions, their states,
// journals, transfer functions. What is accepted of them must be written, and read again, as the same.
#include "target.h"

#include "render/colours/transfer_function_json.h"
#include "studio/json/journal.h"
#include "studio/json/journal_content.h"
#include "studio/json/operation_json.h"
#include "studio/json/session.h"
#include "studio/json/state_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace vs::fuzz {
namespace {

using namespace studio;

std::vector<std::string> textsOf(const std::vector<Operation>& operations) {
    std::vector<std::string> texts;
    for (const Operation& operation : operations) {
        texts.push_back(toJson(operation).dump());
    }
    return texts;
}

void session(Input input) {
    const auto path = fileWith("session.json", input);
    const auto found = unlessRefused([&] { return loadSession(path); });
    if (!found) {
        return;
    }
    saveSession(path, *found);
    const std::string text = contentOf(path);
    const Session back = loadSession(path);
    require(textsOf(back.operations) == textsOf(found->operations), "operations must come back as they were");
    require(back.stateChecksum == found->stateChecksum && back.precision == found->precision,
            "state and precision must come back as they were");
    saveSession(path, back);
    require(contentOf(path) == text, "a session must be written as it was");
}

void function(Input input) {
    const auto path = fileWith("function.json", input);
    if (const auto found = unlessRefused([&] { return render::loadTransferFunction(path); })) {
        render::saveTransferFunction(path, *found);
        require(render::loadTransferFunction(path) == *found, "a function must come back as it was");
    }
}

void journal(Input input) {
    const auto path = fileWith("journal.jsonl", input);
    const auto found = unlessRefused([&] { return readJournal(path); });
    if (!found) {
        return;
    }
    require(found->saved <= found->session.operations.size(), "more operations are saved than there are");
    if (!found->leftOut.empty()) {
        requireOneLine(found->leftOut);
    }
    const auto copy = noFileYet("copy.jsonl");
    Journal(copy, found->session).follow(found->session.operations);
    const JournalContent back = readJournal(copy);
    require(back.leftOut.empty(), "nothing of a new journal is left out, but {}", back.leftOut);
    require(textsOf(back.session.operations).size() == found->session.operations.size(),
            "{} operations instead of {}", back.session.operations.size(), found->session.operations.size());
}

// The file of a state whose table of contents is the input's first line, and whose blocks are the rest. A
// fuzzer that had to keep the table's place in the file right would get nowhere.
std::string stateFileOf(Input input) {
    const auto end = std::find(input.begin(), input.end(), '\n');
    const std::string table(input.begin(), end);
    std::string file = "VSTATE2\n";
    file.append(end == input.end() ? end : end + 1, input.end());
    const std::array<std::uint64_t, 2> trailer{file.size(), table.size()};
    file += table;
    file.append(reinterpret_cast<const char*>(trailer.data()), sizeof(trailer));
    return file;
}

// Writes a state as a session does, and returns the file.
std::string written(const DocumentState& state, const std::filesystem::path& path) {
    StateWriter file(path);
    file.finish(stored(file, state));
    return contentOf(path);
}

void state(Input input) {
    const glm::ivec3 dims(16, 16, 16); // of the scan that make_corpus.py has made states of
    const auto path = fileWith("session.json.state", stateFileOf(input));
    const auto found = unlessRefused([&] {
        StateReader reader(path);
        return readState(reader, dims);
    });
    if (found) {
        const std::string text = written(*found, path);
        StateReader reader(path);
        require(written(readState(reader, dims), path) == text, "a state must be written as it was");
    }
}

} // namespace

std::vector<Target> sessionTargets() {
    return {{"session", session}, {"function", function}, {"journal", journal}, {"state", state}};
}

} // namespace vs::fuzz
