// SPDX-License-Identifier: Apache-2.0
// Sessions with state: a document that was saved and opened again is the one that it was, and goes on as it.
#include "base/hash.h"
#include "gpu/gl_test.h"
#include "gpu/studio/any_edit.h"
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "property.h"
#include "studio/document/document_content.h"
#include "studio/document/document_facts.h"
#include "studio/json/operation_json.h"
#include "studio/json/session_state.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <fstream>
#include <memory>

namespace vs::studio {
namespace {

class SessionStateTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::temp_directory_path() / ("vs_state_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        GlTest::TearDown();
    }

    [[nodiscard]] Session source() const {
        Session session;
        session.volumePath = folder_ / "head.raw"; // which nobody reads here
        return session;
    }
    void save(const Document& document) const {
        std::vector<std::string> notices;
        saveDocument(file(), document, source(), notices);
        EXPECT_TRUE(notices.empty());
    }
    // What is there now, from its state; null, and why, if that cannot be used.
    std::unique_ptr<Document> open(std::vector<std::string>& notices) const {
        volume::Volume head = test::testHead();
        auto state = loadState(file(), loadSession(file()), head, notices);
        return state ? std::make_unique<Document>(std::move(head), std::move(*state)) : nullptr;
    }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "head.json"; }

    std::filesystem::path folder_;
};

// --- anything that a person can do

Operation anything() {
    return test::AnyEdit([](int n) { return *test::below(n); }).edit();
}

bool done(Document& document, const Operation& operation) {
    try {
        document.apply(operation);
        return true;
    } catch (const Error&) {
        return false;
    }
}

void expectEqual(const Document& one, const Document& other) {
    const auto found = differences(contentOf(one), contentOf(other), "the one", "the other");
    for (const std::string& difference : found) {
        RC_LOG() << difference << "\n";
    }
    RC_ASSERT(found.empty());
}

// Undone to the start and redone to the end, both go the same way; and what is done next is the same too.
TEST_F(SessionStateTest, WhatWasOpenedGoesBackAndForthAsWhatWasSaved) {
    int steps = 0;
    test::checkProperty(12, [&] {
        Head saved;
        const int operations = 5 + *test::below(30);
        for (int n = 0; n < operations; ++n) {
            const Operation operation = anything();
            RC_LOG() << toJson(operation).dump() << (done(saved, operation) ? "\n" : ": refused\n");
        }
        if (*test::coin()) {
            saved.setUndoMemory(2000); // some of it lies in a file
        }
        save(saved);
        std::vector<std::string> notices;
        const auto opened = open(notices);
        RC_ASSERT(notices.empty());
        if (!opened) { // nothing was done
            RC_ASSERT(!saved.facts()->canUndo() && !saved.facts()->canRedo());
            return;
        }
        expectEqual(saved, *opened);
        const auto go = [&](const Operation& operation) {
            const bool isDone = done(saved, operation);
            RC_LOG() << "then " << toJson(operation).dump() << (isDone ? "\n" : ": refused\n");
            RC_ASSERT(done(*opened, operation) == isDone);
            return isDone;
        };
        while (go(Redo{})) {
        }
        while (go(Undo{})) {
            expectEqual(saved, *opened);
            ++steps;
        }
        while (go(Redo{})) {
            expectEqual(saved, *opened);
        }
        for (int n = 0; n < 5; ++n) {
            go(anything());
            expectEqual(saved, *opened);
        }
    });
    EXPECT_GT(steps, 60);
}

// --- files

class SavedHead : public SessionStateTest {
protected:
    void SetUp() override {
        SessionStateTest::SetUp();
        document_ = std::make_unique<Head>();
        document_->apply(test::somePeel(6));
        test::grownBrain(*document_, 9);
        save(*document_);
    }
    void TearDown() override {
        document_.reset();
        SessionStateTest::TearDown();
    }
    // That it cannot be opened from its state, with a line that says this.
    void expectDeclined(const std::string& reason) {
        std::vector<std::string> notices;
        EXPECT_EQ(open(notices), nullptr);
        ASSERT_EQ(notices.size(), 1U);
        EXPECT_NE(notices[0].find(file().string()), std::string::npos) << notices[0];
        EXPECT_NE(notices[0].find(reason), std::string::npos) << notices[0];
        EXPECT_EQ(notices[0].find('\n'), std::string::npos) << notices[0];
    }
    [[nodiscard]] bool opens() {
        std::vector<std::string> notices;
        const auto opened = open(notices);
        return opened && notices.empty() &&
               differences(contentOf(*document_), contentOf(*opened), "a", "b").empty();
    }

    std::unique_ptr<Head> document_;
};

TEST_F(SavedHead, IsFoundUnderTheNewNameToo) {
    EXPECT_TRUE(opens());
    // Killed after the session was written and before its state had its name; an older state lies there.
    std::filesystem::rename(statePath(file()), statePath(file()).concat(".new"));
    std::ofstream(statePath(file())) << "an older one";
    EXPECT_TRUE(opens());
}

TEST_F(SavedHead, OfBeforeIsThereUntilTheNewOneIs) {
    const auto olderSession = folder_ / "older.json";
    std::filesystem::copy_file(file(), olderSession);
    std::filesystem::copy_file(statePath(file()), folder_ / "older.state");
    Head other;
    other.apply(test::somePeel(3));
    save(other);
    // Killed after the new state was written and before the session was.
    std::filesystem::rename(statePath(file()), statePath(file()).concat(".new"));
    std::filesystem::rename(folder_ / "older.state", statePath(file()));
    std::filesystem::rename(olderSession, file());
    EXPECT_TRUE(opens());
    save(*document_); // cleans up
    EXPECT_FALSE(std::filesystem::exists(statePath(file()).concat(".new")));
    EXPECT_TRUE(opens());
}

TEST_F(SavedHead, IsDeclinedWhereItDoesNotFit) {
    const auto state = statePath(file());
    std::filesystem::rename(state, folder_ / "elsewhere");
    expectDeclined("is not there");
    std::filesystem::rename(folder_ / "elsewhere", state);

    // Somebody edits the session.
    Session edited = loadSession(file());
    edited.operations.pop_back();
    saveSession(file(), edited);
    expectDeclined("has been changed since");
}

// Wherever a file is cut off or one of its bytes is another one, that is said and nothing else happens.
TEST_F(SavedHead, IsDeclinedWhereItIsDamaged) {
    std::ifstream in(statePath(file()), std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    for (std::size_t n = 0; n < 24; ++n) {
        std::string damaged = whole;
        if (n % 2 == 0) {
            damaged.resize(whole.size() * n / 24);
        } else {
            damaged[whole.size() * n / 24] ^= char(1 << (n % 8));
        }
        std::ofstream(statePath(file()), std::ios::binary) << damaged;
        expectDeclined(statePath(file()).string());
    }
}

// A file that means harm has the checksum of what it is.
TEST_F(SavedHead, IsDeclinedWhereItsContentsMakeNoSense) {
    std::ifstream in(statePath(file()), std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    int opened = 0;
    for (std::size_t n = 0; n < 400; ++n) {
        std::string damaged = whole;
        const std::size_t at = 8 + n * 7919 * 104729 % (whole.size() - 8);
        damaged[at] = char(damaged[at] + 1 + int(n % 251));
        std::ofstream(statePath(file()), std::ios::binary) << damaged;
        Hash64 hash;
        hash.add(std::as_bytes(std::span(damaged)));
        Session session = loadSession(file());
        session.stateChecksum = hash.text();
        saveSession(file(), session);
        try {
            std::vector<std::string> notices;
            const auto document = open(notices);
            if (document) {
                ++opened;
                while (done(*document, Undo{})) {
                }
            } else {
                EXPECT_EQ(notices.size(), 1U);
            }
        } catch (const Error&) {
            // What is compressed is looked at when it is needed.
        }
    }
    EXPECT_LT(opened, 400);
}

TEST_F(SessionStateTest, ASessionWithoutEditsHasNone) {
    Head document;
    save(document);
    EXPECT_FALSE(std::filesystem::exists(statePath(file())));
    EXPECT_TRUE(loadSession(file()).stateChecksum.empty());
}

} // namespace
} // namespace vs::studio
