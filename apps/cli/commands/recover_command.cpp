// SPDX-License-Identifier: Apache-2.0
// vstudio recover: the work of a window that did not end well, as sessions.
#include "commands/commands.h"

#include "base/error.h"
#include "base/log.h"
#include "studio/json/journal_content.h"
#include "studio/json/lost_work.h"

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <memory>

namespace vs::cli {

namespace {

struct RecoverOptions {
    std::string journal; // a name in the journal folder, or a path; empty: all that are there
    std::string folder = ".";
    bool lists = false;
    bool keeps = false;
};

std::string nameOf(const studio::LostWork& lost) {
    return lost.name.empty() ? "made from nothing" : lost.name;
}

void list(const std::vector<studio::LostWork>& all) {
    for (const auto& lost : all) {
        const std::string what =
            !lost.problem.empty() ? "cannot be recovered" : fmt::format("{} edits", lost.edits);
        fmt::print("{}  {:%Y-%m-%d %H:%M}  {}  {}\n", lost.journal.filename().string(),
                   fmt::localtime(lost.when), nameOf(lost), what);
        if (!lost.missing.empty()) {
            fmt::print("  its volume {} is not there\n", lost.missing.string());
        }
        if (!lost.leftOut.empty() || !lost.problem.empty()) {
            fmt::print("  {}\n", lost.problem.empty() ? lost.leftOut : lost.problem);
        }
    }
    if (all.empty()) {
        fmt::print("there is nothing to recover in {}\n", studio::journalFolder().string());
    }
}

// "head-recovered.json", or with a number where that is taken.
std::filesystem::path freeName(const std::filesystem::path& folder, const studio::LostWork& lost) {
    const std::string name = lost.name.substr(0, lost.name.find('.', 1));
    const std::string stem = (name.empty() ? "block" : name) + "-recovered";
    std::filesystem::path path = folder / (stem + ".json");
    for (int n = 2; std::filesystem::exists(path); ++n) {
        path = folder / fmt::format("{}-{}.json", stem, n);
    }
    return path;
}

// Whatever happens between, the work is in the journal or in the session.
void recover(const std::filesystem::path& journal, const RecoverOptions& options) {
    const auto held = studio::HeldJournal::hold(journal);
    if (!held) {
        throw Error("{}: it is not there, or a running program has it in hand; vstudio recover --list names "
                    "those that are free",
                    journal.string());
    }
    const studio::LostWork lost = studio::describeJournal(journal);
    const auto content = studio::readJournal(journal);
    const auto path = freeName(options.folder, lost);
    studio::saveSession(path, content.session);
    fmt::print("{}: {} operations of {} are in {}\n", journal.filename().string(),
               content.session.operations.size(), nameOf(lost), path.string());
    if (!lost.leftOut.empty()) {
        logNotice(lost.leftOut);
    }
    if (!lost.missing.empty()) {
        logNotice(
            fmt::format("its volume {} is not there; say where it is with vstudio run {} --volume FILE, "
                        "or open the session in the window, which asks for it",
                        lost.missing.string(), path.string()));
    }
    if (options.keeps || journal.parent_path() != studio::journalFolder()) {
        return;
    }
    if (lost.leftOut.empty()) {
        held->remove();
    } else {
        logNotice(fmt::format("the damaged journal is kept as {}", held->setAside().string()));
    }
}

std::filesystem::path pathOf(const std::string& journal) {
    const std::filesystem::path path = journal;
    return path.has_parent_path() || std::filesystem::exists(path) ? path : studio::journalFolder() / path;
}

void runRecover(const RecoverOptions& options) {
    if (!options.lists && !options.journal.empty()) {
        recover(pathOf(options.journal), options);
        return;
    }
    const auto all = options.journal.empty() ? studio::lostWork()
                                             : std::vector{studio::describeJournal(pathOf(options.journal))};
    if (options.lists || all.empty()) {
        list(all);
        return;
    }
    std::size_t failed = 0;
    for (const auto& lost : all) {
        if (lost.problem.empty()) {
            recover(lost.journal, options);
        } else {
            ++failed;
            logNotice(lost.problem);
        }
    }
    if (failed > 0) {
        throw Error("{}: {} of {} journals cannot be recovered; see vstudio recover --list",
                    studio::journalFolder().string(), failed, all.size());
    }
}

} // namespace

void addRecoverCommand(CLI::App& app) {
    auto* command = app.add_subcommand(
        "recover", "Write sessions of the work that windows have left behind which did not end well");
    auto options = std::make_shared<RecoverOptions>();
    command->add_option("journal", options->journal,
                        "Which one, as --list names it, or the path of one; without it all that are there");
    command->add_flag("--list", options->lists, "Tell what is there, and write nothing");
    command->add_option("-o,--output", options->folder, "Folder for the sessions; without it this one");
    command->add_flag("--keep", options->keeps,
                      "Leave the journals where they are: windows go on offering them");
    command->callback([options] { runRecover(*options); });
}

} // namespace vs::cli
