// SPDX-License-Identifier: Apache-2.0
#include "render/colours/colour_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vs::render {
namespace {

// What a person without red (protan) or green (deutan) cones sees, in linear sRGB: Machado, Oliveira,
// Fernandes 2009, "A physiologically-based model for simulation of color vision deficiency", table 1,
// severity
// 1. The rows here are the matrices' columns.
const glm::dmat3 kProtan{
    {0.152286, 0.114503, -0.003882}, {1.052583, 0.786281, -0.048116}, {-0.204868, 0.099216, 1.051998}};
const glm::dmat3 kDeutan{
    {0.367322, 0.280085, -0.011820}, {0.860646, 0.672501, 0.042940}, {-0.227968, 0.047413, 0.968881}};

glm::dvec3 seenBy(const glm::dmat3& eye, glm::dvec3 oklab) {
    return oklabFromLinear(glm::clamp(eye * linearFromOklab(oklab), 0.0, 1.0));
}

TEST(Colour, OklabGoesThereAndBack) {
    for (int i = 0; i < 4096; ++i) {
        const Colour c((i & 15) * 17, (i >> 4 & 15) * 17, (i >> 8) * 17);
        EXPECT_EQ(colourFromLinear(linearFromOklab(oklabFromLinear(linearFromColour(c)))), c);
    }
    // The paper's own example values for white and for pure red.
    EXPECT_NEAR(oklabFromLinear({1, 1, 1}).x, 1, 1e-6);
    EXPECT_NEAR(glm::distance(oklabFromLinear({1, 0, 0}), glm::dvec3(0.6280, 0.2249, 0.1258)), 0, 1e-3);
}

TEST(ColourMap, EveryColourCanBeShown) {
    for (const ColourMap& map : colourMaps()) {
        for (const glm::dvec3 oklab : map.oklab) {
            const glm::dvec3 c = linearFromOklab(oklab);
            EXPECT_GE(std::min({c.x, c.y, c.z}), -1e-3) << map.name;
            EXPECT_LE(std::max({c.x, c.y, c.z}), 1 + 1e-3) << map.name;
        }
    }
}

TEST(ColourMap, StepsAreEquallyLargeEverywhere) {
    for (const ColourMap& map : colourMaps()) {
        double least = 1e9;
        double most = 0;
        for (std::size_t i = 1; i < map.oklab.size(); ++i) {
            const double step = glm::distance(map.oklab[i - 1], map.oklab[i]);
            least = std::min(least, step);
            most = std::max(most, step);
        }
        EXPECT_LT(most, 1.03 * least) << map.name;
    }
}

TEST(ColourMap, LightnessRisesAllTheWay) {
    for (const ColourMap& map : colourMaps()) {
        const std::size_t count = map.oklab.size();
        const double mean = (map.oklab.back().x - map.oklab.front().x) / double(count - 1);
        for (std::size_t i = 1; i < count; ++i) {
            const double rise = map.oklab[i].x - map.oklab[i - 1].x;
            if (map.isDiverging) { // up to the middle, then down
                EXPECT_GT(i <= count / 2 ? rise : -rise, 0.001) << map.name << ' ' << i;
            } else {
                EXPECT_GT(rise, 0.6 * mean) << map.name << ' ' << i;
                EXPECT_LT(rise, 1.4 * mean) << map.name << ' ' << i;
            }
        }
    }
}

// Fifteen colours of each map stay in order and apart for colour-blind eyes.
TEST(ColourMap, ColourBlindEyesTellItsColoursApart) {
    constexpr int count = 15; // odd: the middle of a diverging map is one of them
    for (const ColourMap& map : colourMaps()) {
        for (const auto& eye : {kProtan, kDeutan}) {
            for (int i = 0; i < count; ++i) {
                for (int j = 0; j < i; ++j) {
                    const glm::dvec3 a = map.at(i / (count - 1.0));
                    const glm::dvec3 b = map.at(j / (count - 1.0));
                    const double seen = glm::distance(seenBy(eye, a), seenBy(eye, b));
                    EXPECT_GT(seen, 0.02) << map.name << ' ' << i << ' ' << j;
                    EXPECT_GT(seen, 0.5 * glm::distance(a, b)) << map.name << ' ' << i << ' ' << j;
                    if (!map.isDiverging) {
                        EXPECT_GT(seenBy(eye, a).x, seenBy(eye, b).x) << map.name << ' ' << i << ' ' << j;
                    }
                }
            }
        }
    }
}

TEST(ColourMap, OutsideTheEndsCount) {
    const ColourMap* map = findColourMap("ember");
    ASSERT_NE(map, nullptr);
    EXPECT_EQ(map->at(-5), map->oklab.front());
    EXPECT_EQ(map->at(7), map->oklab.back());
    EXPECT_EQ(findColourMap("rainbow"), nullptr);
}

} // namespace
} // namespace vs::render
