// SPDX-License-Identifier: Apache-2.0
#include "gl/kept_programs.h"

#include "base/folder.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/shader_source.h"
#include "gl/shaders/bindings.h"
#include "gpu/gl_test.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace vs::gl {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShader = "gl/shaders/fill_words.comp";

// With a cache folder of its own.
class KeptProgramsTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
    }
    void TearDown() override {
        unsetenv("XDG_CACHE_HOME");
        fs::remove_all(cache_);
        GlTest::TearDown();
    }

    static std::string text() { return expandSource(kShader, {}).text; }

    // Whether something is kept of the shader that the driver takes.
    static bool isKept() {
        const unsigned int program = loadKeptProgram(text());
        detail::deleteProgram(program);
        return program != 0;
    }

    static void expectRight(Program program) {
        Buffer words(4 * sizeof(std::uint32_t), "words");
        words.bindStorage(kWordsStorage);
        program.set("firstWord", 1U).set("wordCount", 2U).set("value", 7U);
        program.dispatch({1, 1, 1}, Barrier::Storage);
        EXPECT_EQ(words.read<std::uint32_t>(4), std::vector<std::uint32_t>({0, 7, 7, 0}));
    }

    [[nodiscard]] fs::path onlyFile() const {
        const auto files = entriesOf(programs_);
        EXPECT_EQ(files.size(), 1U);
        return files.empty() ? fs::path() : files.front();
    }

    static std::string read(const fs::path& file) {
        std::ifstream input(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(input), {}};
    }
    static void write(const fs::path& file, const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
    }

    fs::path cache_ = fs::temp_directory_path() / fmt::format("vs_kept_programs_{}", getpid());
    fs::path programs_ = cache_ / "volume-studio" / "programs";
};

TEST_F(KeptProgramsTest, AProgramIsKeptAndDoesTheSame) {
    EXPECT_FALSE(isKept());
    expectRight(Program(kShader)); // compiled
    ASSERT_TRUE(isKept());
    const auto before = fs::last_write_time(onlyFile());
    expectRight(Program(kShader)); // from the file
    EXPECT_EQ(fs::last_write_time(onlyFile()), before);
}

TEST_F(KeptProgramsTest, AnotherTextIsAnotherProgram) {
    expectRight(Program(kShader));
    EXPECT_EQ(loadKeptProgram(text() + "\n"), 0U);
}

// Another text's file under this one's name, and files that are cut short or changed anywhere.
TEST_F(KeptProgramsTest, WhatIsNotThisProgramWholeIsNotTaken) {
    expectRight(Program(kShader));
    const fs::path file = onlyFile();
    const std::string whole = read(file);
    for (std::size_t size = 0; size < whole.size(); size += 97) {
        write(file, whole.substr(0, size));
        EXPECT_FALSE(isKept()) << "cut to " << size << " bytes";
    }
    for (std::size_t at = 0; at < whole.size(); at += 61) {
        std::string changed = whole;
        changed[at] = char(changed[at] ^ 0x10);
        write(file, changed);
        EXPECT_FALSE(isKept()) << "changed at byte " << at;
    }
    expectRight(Program(kShader));
    EXPECT_TRUE(isKept()) << "it is kept anew";
    keepProgram(Program("gl/shaders/fill_words.comp").name(), "another text");
    for (const fs::path& other : entriesOf(programs_)) {
        if (other != file) {
            fs::copy_file(other, file, fs::copy_options::overwrite_existing);
        }
    }
    EXPECT_FALSE(isKept());
}

TEST_F(KeptProgramsTest, WhereNothingCanBeKeptItIsCompiled) {
    write(cache_, "no folder");
    expectRight(Program(kShader));
    EXPECT_FALSE(isKept());
}

} // namespace
} // namespace vs::gl
