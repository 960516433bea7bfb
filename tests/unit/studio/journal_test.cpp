// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "studio/json/journal.h"
#include "studio/json/journal_content.h"
#include "studio/json/lost_work.h"
#include "studio/json/operation_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

namespace vs::studio {
namespace {

class JournalTest : public testing::Test {
protected:
    JournalTest() {
        std::filesystem::create_directories(folder_);
        source_.volumePath = "/scans/head.nrrd";
        source_.volumeChecksum = "0123456789abcdef";
        source_.series = "2";
        source_.frame = 3;
        source_.precision = sculpt::Precision::Bits8;
    }
    ~JournalTest() override { std::filesystem::remove_all(folder_); }

    static std::vector<Operation> someLog() {
        Peel peel;
        peel.mask = {Shape::Ellipse, {{1, 2}, {30, 40}}};
        peel.layers = 3.5;
        peel.canvas = Canvas{};
        return {setViewTo(View{}), peel, Undo{}, Redo{}};
    }

    static std::vector<std::string> texts(const std::vector<Operation>& operations) {
        std::vector<std::string> result;
        for (const Operation& operation : operations) {
            result.push_back(toJson(operation).dump());
        }
        return result;
    }

    void cut(std::uintmax_t bytes) const {
        std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - bytes);
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("vs_journal_" + std::to_string(getpid()));
    std::filesystem::path path_ = folder_ / "below" / "head.jsonl";
    Session source_;
};

TEST_F(JournalTest, ReadsBackVolumeAndOperations) {
    const auto log = someLog();
    Journal(path_, source_).follow(log);
    const JournalContent content = readJournal(path_);
    EXPECT_EQ(content.session.volumePath, source_.volumePath);
    EXPECT_EQ(content.session.volumeChecksum, source_.volumeChecksum);
    EXPECT_EQ(content.session.series, source_.series);
    EXPECT_EQ(content.session.frame, source_.frame);
    EXPECT_EQ(content.session.precision, source_.precision);
    EXPECT_EQ(texts(content.session.operations), texts(log));
    EXPECT_EQ(content.unsavedEdits(), 3U); // looking is no edit
}

// Whatever was followed is in the file at once: nothing waits for a clean end.
TEST_F(JournalTest, WhatWasFollowedIsThereWhileTheJournalIsOpen) {
    Journal journal(path_, source_);
    std::vector<Operation> log;
    for (const Operation& operation : someLog()) {
        log.push_back(operation);
        journal.follow(log);
        EXPECT_EQ(texts(readJournal(path_).session.operations), texts(log));
    }
}

TEST_F(JournalTest, SurvivesTheDeathOfTheProcess) {
    const pid_t child = fork();
    if (child == 0) {
        Journal journal(path_, source_);
        journal.follow(someLog());
        raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(texts(readJournal(path_).session.operations), texts(someLog()));
}

// Cut anywhere behind the first line: all whole lines are there, and nothing else.
TEST_F(JournalTest, LosesNoMoreThanTheLineThatIsCut) {
    const auto log = someLog();
    Journal(path_, source_).follow(log);
    const auto lastLine =
        toJson(log.back()).dump().size() + std::string(R"({"n":3,"operation":})").size() + 1; // and its end
    for (std::size_t bytes = 1; bytes <= lastLine; ++bytes) {
        cut(1);
        EXPECT_EQ(readJournal(path_).session.operations.size(), log.size() - 1) << bytes << " bytes cut";
    }
    cut(1); // the end of the line before
    EXPECT_EQ(readJournal(path_).session.operations.size(), log.size() - 2);
}

// A rewinding button held down changes the last operation of the log instead of adding one.
TEST_F(JournalTest, ARewindThatGoesOnStaysOneOperation) {
    Journal journal(path_, source_);
    std::vector<Operation> log{Undo{}, Rewind{1}};
    journal.follow(log);
    log.back() = Rewind{4};
    journal.follow(log);
    journal.follow(log); // nothing new
    log.emplace_back(Grow{2});
    journal.follow(log);
    EXPECT_EQ(texts(readJournal(path_).session.operations), texts(log));
}

TEST_F(JournalTest, WhatASessionHoldsNeedsNoRecovery) {
    Journal journal(path_, source_);
    auto log = someLog();
    journal.follow(log);
    journal.noteSaved("/sessions/head.json");
    JournalContent content = readJournal(path_);
    EXPECT_EQ(content.unsavedEdits(), 0U);
    EXPECT_EQ(content.savedAs, "/sessions/head.json");
    log.emplace_back(UnCut{});
    journal.follow(log);
    EXPECT_EQ(readJournal(path_).unsavedEdits(), 1U);
}

TEST_F(JournalTest, NeverWritesOverAnother) {
    const Journal journal(path_, source_);
    EXPECT_THROW(Journal(path_, source_), WriteError);
}

// What precedes a damaged line is there, and it is said what is not.
TEST_F(JournalTest, ADamagedLineIsLeftOutAndTold) {
    const auto log = someLog();
    for (const char* damage : {R"({"n": 4, "operation": {"op": "bake"}})", "{", "\0\1\2", "[[1]]", ""}) {
        Journal(path_, source_).follow(log);
        std::ofstream(path_, std::ios::app) << damage << "\n";
        const JournalContent content = readJournal(path_);
        EXPECT_EQ(texts(content.session.operations), texts(log)) << damage;
        EXPECT_NE(content.leftOut.find("head.jsonl: line 6"), std::string::npos) << content.leftOut;
        EXPECT_NE(content.leftOut.find("this line is left out"), std::string::npos) << content.leftOut;
        std::filesystem::remove(path_);
    }
}

// Operations behind it need it; a line that begins anew, as after a full disk, does not.
TEST_F(JournalTest, OfWhatFollowsADamagedLineThatIsReadWhichDoesNotNeedIt) {
    Journal journal(path_, source_);
    auto log = someLog();
    journal.follow(log);
    std::ofstream(path_, std::ios::app) << R"({"n":4,"opera)"
                                        << "\n";
    log.emplace_back(UnCut{});
    journal.follow(log);
    const JournalContent whole = readJournal(path_);
    EXPECT_EQ(texts(whole.session.operations), texts(log));
    EXPECT_NE(whole.leftOut.find("line 6"), std::string::npos) << whole.leftOut;
    std::ofstream(path_, std::ios::app) << R"({"n":6,"operation":{"op":"undo"}})"
                                        << "\n"
                                        << R"({"n":7,"operation":{"op":"redo"}})"
                                        << "\n";
    const JournalContent cutShort = readJournal(path_);
    EXPECT_EQ(texts(cutShort.session.operations), texts(log));
    EXPECT_NE(cutShort.leftOut.find("3 lines are left out"), std::string::npos) << cutShort.leftOut;
}

TEST_F(JournalTest, WithoutAFirstLineNothingCanBeRead) {
    std::filesystem::create_directories(path_.parent_path());
    EXPECT_THROW(readJournal(path_), SessionError); // there is none
    std::ofstream(path_) << "{\"volumeStudioJournal\": 1}\n";
    try {
        readJournal(path_);
        FAIL() << "a journal of nothing was read";
    } catch (const SessionError& error) {
        EXPECT_NE(std::string(error.what()).find("head.jsonl: line 1"), std::string::npos) << error.what();
    }
}

// The process that writes it has it; then whoever comes first.
TEST_F(JournalTest, IsHeldByOneAtATime) {
    {
        const Journal journal(path_, source_);
        EXPECT_FALSE(HeldJournal::hold(path_));
    }
    auto held = HeldJournal::hold(path_);
    ASSERT_TRUE(held);
    EXPECT_FALSE(HeldJournal::hold(path_));
    const auto aside = held->setAside();
    EXPECT_TRUE(std::filesystem::exists(aside));
    EXPECT_FALSE(HeldJournal::hold(path_)); // it is not there
}

TEST_F(JournalTest, SaysThatItsFileWasRemoved) {
    Journal journal(path_, source_);
    std::filesystem::remove(path_);
    EXPECT_FALSE(journal.isThere());
    EXPECT_THROW(journal.follow(someLog()), WriteError);
}

// A disk that is full takes half a line; when it has room again the journal goes on as if nothing had been.
TEST_F(JournalTest, GoesOnAfterAFullDisk) {
    Journal journal(path_, source_);
    auto log = someLog();
    journal.follow(log);
    log.emplace_back(UnCut{});
    const auto written = std::filesystem::file_size(path_);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, SIG_IGN);
    for (rlim_t room = 0; room < 20; ++room) {
        const rlimit full{written + room, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &full);
        EXPECT_THROW(journal.follow(log), WriteError);
        setrlimit(RLIMIT_FSIZE, &before);
        const JournalContent meanwhile = readJournal(path_);
        EXPECT_EQ(texts(meanwhile.session.operations), texts(someLog()));
        EXPECT_EQ(meanwhile.leftOut, "");
    }
    signal(SIGXFSZ, SIG_DFL);
    journal.follow(log);
    EXPECT_EQ(texts(readJournal(path_).session.operations), texts(log));
}

// Only what nobody writes and no session holds is lost.
TEST_F(JournalTest, LostWorkIsWhatNobodyHas) {
    setenv("XDG_STATE_HOME", folder_.c_str(), 1);
    const auto journals = journalFolder();
    Journal(journals / "lost.jsonl", source_).follow(someLog());
    Journal(journals / "looked.jsonl", source_).follow({setViewTo(View{})});
    {
        Journal saved(journals / "saved.jsonl", source_);
        saved.follow(someLog());
        saved.noteSaved("/sessions/head.json");
    }
    const Journal running(journals / "running.jsonl", source_);
    std::ofstream(journals / "empty.jsonl").close();
    std::ofstream(journals / "nonsense.jsonl") << "nonsense\n";
    std::ofstream(journals / "lost.jsonl.damaged") << "set aside\n";
    const auto all = lostWork();
    unsetenv("XDG_STATE_HOME");
    ASSERT_EQ(all.size(), 2U);
    const auto& lost = all[0].problem.empty() ? all[0] : all[1];
    const auto& nonsense = all[0].problem.empty() ? all[1] : all[0];
    EXPECT_EQ(lost.name, "head.nrrd");
    EXPECT_EQ(lost.edits, 3U);
    EXPECT_EQ(lost.missing, "/scans/head.nrrd");
    EXPECT_NE(nonsense.problem.find("nonsense.jsonl: line 1"), std::string::npos) << nonsense.problem;
    EXPECT_FALSE(std::filesystem::exists(journals / "looked.jsonl"));
    EXPECT_FALSE(std::filesystem::exists(journals / "saved.jsonl"));
    EXPECT_FALSE(std::filesystem::exists(journals / "empty.jsonl"));
    EXPECT_TRUE(std::filesystem::exists(journals / "running.jsonl"));
}

} // namespace
} // namespace vs::studio
