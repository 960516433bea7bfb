// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <vector>

namespace vs {
namespace {

class AtomicFile : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("vs_atomic_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    static std::string contentOf(const std::filesystem::path& path) {
        std::ifstream file(path);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }

    std::filesystem::path folder_;
};

TEST_F(AtomicFile, ReplacesTheWholeFile) {
    writeFileAtomically(folder_ / "a.txt", std::string("first and long"));
    writeFileAtomically(folder_ / "a.txt", std::string("second"));
    EXPECT_EQ(contentOf(folder_ / "a.txt"), "second");
}

TEST_F(AtomicFile, AFailedWriteLeavesTheOldFileAndNothingElse) {
    writeFileAtomically(folder_ / "a.nii.gz", std::string("old"));
    EXPECT_THROW(writeAtomically(folder_ / "a.nii.gz",
                                 [](const std::filesystem::path& temporary) {
                                     EXPECT_TRUE(temporary.string().ends_with(".nii.gz"));
                                     std::ofstream(temporary) << "half";
                                     throw Error("the pen broke\nin two");
                                 }),
                 WriteError);
    EXPECT_EQ(contentOf(folder_ / "a.nii.gz"), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

// The person has named one file and gets to know of that one, whichever it is that cannot be filled.
TEST_F(AtomicFile, WhatGoesWrongIsSaidOfTheFileThatWasNamed) {
    const FileWriting files[] = {{folder_ / "a.zraw", [](const auto&) { throw Error("no ink"); }},
                                 {folder_ / "a.mhd", writingOf("header")}};
    for (const bool isThere : {true, false}) {
        try {
            writeAllAtomically(files);
            FAIL();
        } catch (const WriteError& error) {
            const std::string text = error.what();
            EXPECT_EQ(text.rfind((folder_ / "a.mhd").string() + ": ", 0), 0U) << text;
            EXPECT_EQ(text.find("no ink") != std::string::npos, isThere) << text;
        }
        std::filesystem::remove_all(folder_);
    }
}

TEST_F(AtomicFile, AMissingFolderIsNamedInOneLine) {
    try {
        writeFileAtomically(folder_ / "gone" / "a.txt", std::string("x"));
        FAIL();
    } catch (const WriteError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("gone does not exist"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST_F(AtomicFile, WhatIsNoRegularFileIsLeftAlone) {
    const auto expectRefused = [](const std::filesystem::path& path) {
        EXPECT_THROW(writeFileAtomically(path, std::string("x")), WriteError) << path;
    };
    const auto pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    expectRefused(pipe);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    expectRefused(folder_);
    std::filesystem::create_symlink("/dev/null", folder_ / "null");
    expectRefused(folder_ / "null");
    EXPECT_TRUE(std::filesystem::is_character_file(folder_ / "null"));
    std::filesystem::create_symlink("round", folder_ / "round");
    expectRefused(folder_ / "round");
}

TEST_F(AtomicFile, FilesThatBelongTogetherAreAllNewOrAllOld) {
    const auto write = [&](const std::string& content, bool isBlocked) {
        const std::vector<FileWriting> files{
            {folder_ / "a.obj", writingOf(content)},
            {folder_ / "a.mtl", writingOf(content)},
            {folder_ / "b.txt", [&](const std::filesystem::path& temporary) {
                 std::ofstream(temporary) << content;
                 if (isBlocked) { // nothing can be renamed onto a folder that is not empty
                     std::filesystem::remove(folder_ / "b.txt");
                     std::filesystem::create_directories(folder_ / "b.txt" / "in the way");
                 }
             }}};
        writeAllAtomically(files);
    };
    write("old", false);
    std::filesystem::remove(folder_ / "a.mtl");
    EXPECT_THROW(write("new", true), WriteError);
    EXPECT_EQ(contentOf(folder_ / "a.obj"), "old");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.mtl")); // nor was it there before
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 2);
    std::filesystem::remove_all(folder_ / "b.txt");
    write("new", false);
    EXPECT_EQ(contentOf(folder_ / "a.obj"), "new");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
}

TEST_F(AtomicFile, WhatAKilledRunHasLeftIsCleared) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            writeAtomically(folder_ / "a.txt", [](const std::filesystem::path& temporary) {
                std::ofstream(temporary) << "half";
                raise(SIGKILL);
            });
        } catch (...) {
        }
        _exit(1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
    const auto others = folder_ / (".b.part" + std::to_string(child) + "@other1.txt"); // of another machine
    std::ofstream(others) << "half";
    std::ofstream(folder_ / ".mine.party") << "a file of the person's own";
    writeFileAtomically(folder_ / "c.txt", std::string("whole"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
    EXPECT_TRUE(std::filesystem::exists(others));
}

TEST_F(AtomicFile, ALinkStaysAndItsTargetIsReplaced) {
    std::filesystem::create_directory(folder_ / "below");
    writeFileAtomically(folder_ / "below" / "a.txt", std::string("old"));
    std::filesystem::create_symlink("below/a.txt", folder_ / "link.txt");
    std::filesystem::create_symlink(folder_ / "link.txt", folder_ / "link2.txt");
    std::filesystem::create_symlink("below/new.txt", folder_ / "dangling.txt");
    writeFileAtomically(folder_ / "link2.txt", std::string("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link2.txt"));
    EXPECT_EQ(contentOf(folder_ / "below" / "a.txt"), "new");
    writeFileAtomically(folder_ / "dangling.txt", std::string("made"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "dangling.txt"));
    EXPECT_EQ(contentOf(folder_ / "below" / "new.txt"), "made");
}

} // namespace
} // namespace vs
