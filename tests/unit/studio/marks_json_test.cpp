// SPDX-License-Identifier: Apache-2.0
// Marks in the state of a session: they come back as they were, and what no program would have written is
// refused.
#include "studio/json/marks_json.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <limits>

namespace vs::studio {
namespace {

using Numbers = std::vector<std::uint64_t>;

class MarksJsonTest : public ::testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(file_); }

    // What `write` says is kept in the file, and read again.
    template <typename Write>
    field::SharedMarks again(Write write, glm::ivec3 dims = kDims) {
        StateWriter writer(file_);
        writer.finish({{"marks", write(writer)}});
        StateReader reader(file_);
        return readMarks(reader, reader.contents().member("marks"), dims);
    }
    // A list of numbers; {begin} of it are followed by where a brick lies.
    void expectRefused(const Numbers& begin, const field::MarkBrick& brick, glm::ivec3 dims = kDims) {
        const auto write = [&](StateWriter& writer) {
            const auto block = writer.list(std::vector<field::MarkBrick>{brick});
            Numbers numbers = begin;
            for (int i = 0; i < 3; ++i) {
                numbers.push_back(block.at(std::size_t(i)).get<std::uint64_t>());
            }
            return writer.list(numbers);
        };
        EXPECT_THROW(again(write, dims), SessionError);
    }
    static field::MarkBrick someBrick() {
        field::MarkBrick brick;
        brick.set(5, {1, 2, 3, 200, 255});
        return brick;
    }

    static constexpr glm::ivec3 kDims{40, 30, 20};
    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("vs_marks_" + std::to_string(getpid()) + ".state");
};

TEST_F(MarksJsonTest, ComeBackAsTheyWereAndAreWrittenOnce) {
    const auto brick = std::make_shared<const field::MarkBrick>(someBrick());
    const auto marks =
        std::make_shared<const field::Marks>(field::Marks({kDims, {2, 2, 4}}, {{3, brick}, {7, brick}}));
    const auto write = [&](StateWriter& writer) {
        auto said = stored(writer, marks);
        EXPECT_EQ(stored(writer, marks), said);
        return said;
    };
    const field::SharedMarks read = again(write);
    EXPECT_TRUE(*read == *marks);
    EXPECT_EQ(read->bricks()[0].second, read->bricks()[1].second) << "one brick in two places is one";
    const auto nothing = std::make_shared<const field::Marks>();
    EXPECT_TRUE(again([&](StateWriter& writer) { return stored(writer, nothing); })->isEmpty());
}

TEST_F(MarksJsonTest, RefuseWhatWouldBeWrong) {
    expectRefused({0, 2, 4, 3}, someBrick());
    expectRefused({2, 2, 33, 3}, someBrick());
    expectRefused({2, 2, 4, 1000000}, someBrick()); // there is no such place
    expectRefused({2, 2, 4, std::numeric_limits<std::uint64_t>::max()}, someBrick());
    expectRefused({2, 2, 4, 3}, field::MarkBrick());               // in which nothing is marked
    expectRefused({2, 2, 4}, someBrick());                         // a number is missing
    expectRefused({32, 32, 32, 3}, someBrick(), glm::ivec3(1024)); // as many bricks as no memory has
    EXPECT_THROW(again([](StateWriter& writer) { return writer.list(Numbers{2, 2}); }), SessionError);
}

} // namespace
} // namespace vs::studio
