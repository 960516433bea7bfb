// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/self_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace vs::studio {
namespace {

TEST(SelfCheckTest, ATallyCountsWhatIsFartherOffThanAllowedAndKeepsTheWorst) {
    Tally tally;
    tally.about("weights");
    tally.compare(1.04, 1, 0.05);
    EXPECT_EQ(tally.wrong(), 0U);
    EXPECT_EQ(tally.worst().what, "weights");
    tally.about("lengths");
    tally.compare(7, 5, 1);
    tally.compare(9, 5, 1);
    tally.compare(6, 5, 1);
    EXPECT_EQ(tally.values(), 4U);
    EXPECT_EQ(tally.wrong(), 2U);
    EXPECT_EQ(tally.worst().what, "lengths");
    EXPECT_DOUBLE_EQ(tally.worst().error, 4);
    tally.about("counts");
    tally.compare(3, 2);
    EXPECT_EQ(tally.worst().what, "counts") << "where nothing is allowed any error is the worst";
}

TEST(SelfCheckTest, AValueThatIsNoNumberIsWrong) {
    Tally tally;
    tally.compare(std::nan(""), 0, 1e9);
    EXPECT_EQ(tally.wrong(), 1U);
    EXPECT_TRUE(std::isinf(tally.worst().error));
}

TEST(SelfCheckTest, ListsOfDifferentLengthsAreWrong) {
    constexpr std::array found{1.0, 2.0};
    constexpr std::array expected{1.0, 2.0, 3.0};
    Tally tally;
    tally.compareAll(std::span<const double>(found), std::span<const double>(expected));
    EXPECT_EQ(tally.wrong(), 1U);
}

TEST(SelfCheckTest, AStageIsRightOnlyIfSomethingWasComparedAndNothingWentWrong) {
    StageResult result;
    EXPECT_FALSE(result.isOk()) << "nothing was compared";
    result.tally.compare(1, 1);
    EXPECT_TRUE(result.isOk());
    result.errors = 1;
    EXPECT_FALSE(result.isOk());
    result.errors = 0;
    result.failure = "a shader does not compile";
    EXPECT_FALSE(result.isOk());
}

TEST(SelfCheckTest, NoPathIsLeftInAMessage) {
    EXPECT_EQ(withoutPaths("render/shaders/cast_rays.comp:12: 'a' undeclared"),
              "cast_rays:12: 'a' undeclared");
    EXPECT_EQ(withoutPaths("/home/ann/my.scan.nii.gz: no room\nat all"), "a path: no room at all");
    EXPECT_EQ(withoutPaths("cannot open '/tmp/a b/c.so'"), "cannot open 'a path b/c'");
    EXPECT_EQ(withoutPaths("off by 0.5, 3 of 4"), "off by 0.5, 3 of 4");
}

TEST(SelfCheckTest, EachStageHasANameOfItsOwn) {
    std::set<std::string> names;
    for (const StageCheck& check : stageChecks()) {
        EXPECT_TRUE(names.insert(check.name).second) << check.name;
    }
}

} // namespace
} // namespace vs::studio
