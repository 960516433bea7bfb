// SPDX-License-Identifier: Apache-2.0
#include "image/axis.h"
#include "image/chart.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vs::image {
namespace {

TEST(Axis, TicksAreRoundEvenAndInside) {
    EXPECT_EQ(roundTicks({0, 10}, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(roundTicks({0, 1}, 5), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(roundTicks({-1024, 3071}, 6), (std::vector<double>{-1000, 0, 1000, 2000, 3000}));
    for (const Range range :
         {Range{0, 1}, {-3, 17}, {1e6, 1e6 + 1}, {-1e-9, 2e-9}, {0.1, 0.3}, {-7, -6.999}}) {
        for (int most = 2; most <= 12; ++most) {
            const auto ticks = roundTicks(range, most);
            ASSERT_GE(ticks.size(), 1U);
            EXPECT_LE(ticks.size(), std::size_t(most));
            EXPECT_GE(ticks.front(), range.lo - 1e-6 * range.width());
            EXPECT_LE(ticks.back(), range.hi + 1e-6 * range.width());
            for (std::size_t i = 2; i < ticks.size(); ++i) {
                EXPECT_NEAR(ticks[i] - ticks[i - 1], ticks[1] - ticks[0], 1e-6 * range.width());
            }
        }
    }
}

TEST(Axis, ThereAreAsManyTicksAsFit) {
    // From one kind of step to the next it is a factor of 2.5 at most, so hardly less than a third is used.
    for (double width = 1; width < 1000; width *= 1.07) {
        EXPECT_GE(roundTicks({0, width}, 10).size(), 4U) << width;
    }
}

TEST(Axis, AnEmptyRangeHasNoTicks) {
    EXPECT_TRUE(roundTicks({5, 5}, 6).empty());
    EXPECT_TRUE(roundTicks({5, 4}, 6).empty());
}

TEST(Axis, DecadesAreThinnedEvenly) {
    EXPECT_EQ(decadeTicks({1, 1000}, 10), (std::vector<double>{1, 10, 100, 1000}));
    EXPECT_EQ(decadeTicks({1, 999}, 10), (std::vector<double>{1, 10, 100}));
    EXPECT_EQ(decadeTicks({1, 1e6}, 4), (std::vector<double>{1, 100, 1e4, 1e6}));
    EXPECT_LE(decadeTicks({1, 1e9}, 3).size(), 3U);
    EXPECT_EQ(decadeTicks({1, 1}, 5), (std::vector<double>{1}));
}

TEST(Axis, LabelsAreSetAsInPrint) {
    EXPECT_EQ(tickLabel(0), "0");
    EXPECT_EQ(tickLabel(-0.5), "\u22120.5");
    EXPECT_EQ(tickLabel(3 * 0.1), "0.3");
    EXPECT_EQ(tickLabel(2500), "2500");
    EXPECT_EQ(tickLabel(12000), "12\u2009000");
    EXPECT_EQ(tickLabel(-7221032), "\u22127\u2009221\u2009032");
    EXPECT_EQ(decadeLabel(1), "1");
    EXPECT_EQ(decadeLabel(100), "100");
    EXPECT_EQ(decadeLabel(1e5), "10⁵");
    EXPECT_EQ(decadeLabel(1e12), "10¹²");
    EXPECT_EQ(decadeLabel(0.01), "10⁻²");
}

BarChart exampleBars() {
    BarChart chart;
    chart.title = "head.nii.gz";
    chart.note = "100 voxels";
    chart.across = {{0, 10}, "intensity"};
    chart.counts = {0, 1, 1000, 0, 50};
    return chart;
}

// Pixels of one colour.
int countOf(const Image& image, int red, int green, int blue) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        count += image.rgba[i] == red && image.rgba[i + 1] == green && image.rgba[i + 2] == blue ? 1 : 0;
    }
    return count;
}

TEST(Chart, IsOpaqueAndOfTheSizeAskedFor) {
    for (const glm::ivec2 size :
         {kSmallestChart, glm::ivec2{400, 300}, {1200, 800}, {2000, 300}, {300, 2000}}) {
        const Image image = drawChart(exampleBars(), size);
        EXPECT_EQ(glm::ivec2(image.width, image.height), size);
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
            ASSERT_EQ(image.rgba[i], 255);
        }
    }
}

TEST(Chart, BarsAreAsHighAsTheirCounts) {
    BarChart chart = exampleBars();
    chart.isLogarithmic = false;
    chart.counts = {1, 2, 4};
    const int all = countOf(drawChart(chart, {600, 400}), 0, 92, 148);
    chart.counts = {0, 0, 4};
    const int third = countOf(drawChart(chart, {600, 400}), 0, 92, 148);
    EXPECT_GT(third, 1000);
    EXPECT_NEAR(double(all) / third, 7.0 / 4, 0.03); // edges of bars are mixed colours
}

TEST(Chart, ASingleVoxelShowsOnALogarithmicAxis) {
    BarChart chart = exampleBars();
    chart.counts = {1e6, 0, 0};
    const int without = countOf(drawChart(chart, {600, 400}), 0, 92, 148);
    chart.counts = {1e6, 0, 1};
    EXPECT_GT(countOf(drawChart(chart, {600, 400}), 0, 92, 148), without + 500);
}

TEST(Chart, TheShadedRangeIsDrawnOnlyWhereItIsOnTheAxis) {
    // Bars outside the range are grey.
    const auto greyOf = [](const BarChart& chart) {
        return countOf(drawChart(chart, {600, 400}), 158, 168, 179);
    };
    BarChart chart = exampleBars();
    EXPECT_EQ(greyOf(chart), 0);
    chart.shaded = {{2, 6}};
    chart.shadedLabel = "displayed range 2 to 6";
    EXPECT_GT(greyOf(chart), 3000);
    const int blue = countOf(drawChart(chart, {600, 400}), 0, 92, 148);
    chart.shaded = {{4, 5}};
    EXPECT_NEAR(countOf(drawChart(chart, {600, 400}), 0, 92, 148), 0.5 * blue, 0.05 * blue);
    chart.shaded = {{20, 60}};
    EXPECT_EQ(greyOf(chart), 0);
}

TEST(Chart, ALongTitleIsShortenedAndNothingElseMoves) {
    BarChart chart = exampleBars();
    const Image before = drawChart(chart, {600, 400});
    chart.title = std::string(300, 'W') + "é.nii.gz";
    const Image after = drawChart(chart, {600, 400});
    for (int y = 40; y < 400; ++y) { // below the heading
        for (int x = 0; x < 600; ++x) {
            ASSERT_EQ(before.pixel(x, y)[0], after.pixel(x, y)[0]) << x << ", " << y;
        }
    }
}

TEST(Chart, DensityCellsHaveTheColoursOfTheirCounts) {
    DensityChart chart;
    chart.across = {{0, 4}, "intensity"};
    chart.up = {{0, 2}, "gradient"};
    chart.bins = {4, 2};
    chart.counts = {0, 0, 0, 0, 0, 0, 0, 9};
    chart.isLogarithmic = false;
    for (int i = 0; i < 64; ++i) {
        chart.colours.emplace_back(20 + 3 * i, 10 + 3 * i, 60 + i);
    }
    const Image image = drawChart(chart, {800, 600});
    const glm::ivec3 dark = chart.colours.front();
    const glm::ivec3 light = chart.colours.back();
    const int darks = countOf(image, dark.x, dark.y, dark.z);
    const int lights = countOf(image, light.x, light.y, light.z);
    EXPECT_GT(lights, 10000);
    EXPECT_NEAR(double(darks) / lights, 7, 0.1);
    // The last cell of both axes: the upper right one.
    EXPECT_EQ(image.pixel(600, 100)[0], light.x);
    EXPECT_EQ(image.pixel(600, 450)[0], dark.x);
    EXPECT_EQ(image.pixel(150, 100)[0], dark.x);
}

} // namespace
} // namespace vs::image
