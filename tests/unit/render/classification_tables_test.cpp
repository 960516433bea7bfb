// SPDX-License-Identifier: Apache-2.0
#include "render/colours/classification_tables.h"

#include <gtest/gtest.h>

namespace vs::render {
namespace {

TEST(ClassificationTables, ResolutionIsSpentWhereTheFunctionAndTheDataAre) {
    TransferFunction f;
    f.points = {{100, 0}, {300, 1}};
    EXPECT_EQ(makeTables(f, {-1000, 1e6}, 1).values, (Range{100, 300}));
    EXPECT_EQ(makeTables(f, {200, 1e6}, 1).values, (Range{200, 300}));
    const auto beyond = makeTables(f, {500, 900}, 1);
    EXPECT_EQ(beyond.values, (Range{500, 500}));
    EXPECT_EQ(beyond.main.front().w, 1.0F) << "all of the data lies above the last point";
}

TEST(ClassificationTables, OpacityIsPerStep) {
    TransferFunction f;
    f.points = {{0, 0.75}};
    EXPECT_NEAR(makeTables(f, {0, 1}, 2).main[0].w, 0.75, 1e-6);
    f.unitMm = 4;
    EXPECT_NEAR(makeTables(f, {0, 1}, 2).main[0].w, 0.5, 1e-6);
}

TEST(ClassificationTables, EdgesOfAPlaneAreClear) {
    TransferFunction f;
    f.kind = FunctionKind::TwoD;
    f.shapes = {{Trapezoid{{20, 60}, {20, 60}, {5, 10}, {0, 0}}, {}, 1}};
    const auto tables = makeTables(f, {0, 100}, 1);
    const int w = tables.size.x;
    for (int j = 0; j < tables.size.y; ++j) {
        EXPECT_EQ(tables.main[std::size_t(j * w)].w, 0);
        EXPECT_EQ(tables.main[std::size_t(j * w + w - 1)].w, 0);
    }
    const auto all = std::uint32_t(w * tables.size.y);
    EXPECT_GT(tables.visibleBefore.back(), all / 2);
    EXPECT_LT(tables.visibleBefore.back(), all);
    const auto width = std::size_t(tables.visibleSize.x);
    EXPECT_EQ(tables.visibleBefore[width - 1], 0U) << "no rows";
    const auto perRow = tables.visibleBefore.back() / std::uint32_t(tables.size.y);
    EXPECT_LE(tables.visibleBefore[11 * width - 1], 11 * perRow);
}

} // namespace
} // namespace vs::render
