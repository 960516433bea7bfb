// SPDX-License-Identifier: Apache-2.0
#include "marking/pen_letters.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vs::marking {
namespace {

TEST(PenLettersTest, StandInALineOneHighAboutTheMiddle) {
    for (const std::string text : {"R", "HE", "X", "L5/S1 I"}) {
        glm::dvec2 lo(1e9);
        glm::dvec2 hi(-1e9);
        for (const auto& line : penLetters(text)) {
            ASSERT_FALSE(line.empty());
            for (const glm::dvec2& p : line) {
                lo = glm::min(lo, p);
                hi = glm::max(hi, p);
            }
        }
        EXPECT_NEAR(lo.y, -0.5, 0.07) << text; // curves cut the corners of what controls them
        EXPECT_NEAR(hi.y, 0.5, 0.07) << text;
        EXPECT_NEAR(lo.x, -hi.x, 1e-9) << text;
    }
    EXPECT_LT(penLetters("T").front().front().y, 0) << "y points down: the bar of a T is above";
}

TEST(PenLettersTest, EachCharacterHasLinesOfItsOwn) {
    const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-=/.,:?!*<>()";
    std::vector<PenLines> seen;
    for (const char character : all) {
        const auto lines = penLetters(std::string(1, character));
        EXPECT_FALSE(lines.empty()) << character;
        const bool isNew = std::find(seen.begin(), seen.end(), lines) == seen.end();
        EXPECT_TRUE(isNew || character == '0') << character << " looks like another one"; // 0 is an O
        seen.push_back(lines);
    }
    EXPECT_EQ(penLetters("a"), penLetters("A"));
    EXPECT_EQ(penLetters("\u00fc"), penLetters("\u00dc"));
    EXPECT_TRUE(penLetters(" ").empty());
}

TEST(PenLettersTest, SayWhatTheyCannotWrite) {
    EXPECT_EQ(unwritable("R 12 \u00dc\u00e4 45\u00b0"), "");
    EXPECT_EQ(unwritable("a#b"), "#");
    EXPECT_EQ(unwritable("\u4e2d"), "\u4e2d");
    EXPECT_TRUE(penLetters("#").empty());
}

} // namespace
} // namespace vs::marking
