// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "studio/json/journal.h"
#include "studio/json/operation_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
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

TEST_F(JournalTest, DamageIsToldWithItsLine) {
    std::filesystem::create_directories(path_.parent_path());
    EXPECT_THROW(readJournal(path_), SessionError); // there is none
    Journal(path_, source_).follow(someLog());
    std::ofstream(path_, std::ios::app) << "{\"n\": 4, \"operation\": {\"op\": \"bake\"}}\n";
    try {
        readJournal(path_);
        FAIL() << "an operation that is not known was read";
    } catch (const SessionError& error) {
        EXPECT_NE(std::string(error.what()).find("head.jsonl: line 6"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace vs::studio
