// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/stroke_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vs::studio {
namespace {

constexpr ElementBox kEverywhere{glm::ivec2(-(1 << 20)), glm::ivec2(1 << 20)};
constexpr double kRasterPitch = 0.7;

// What an element has seen of a mask's way, by looking at every place on it.
struct Passed {
    float mask = 0;
    float depth = 0; // where at least half of it was covered, else where any was
};

Passed passedAt(glm::ivec2 e, const sculpt::MaskRaster& mask, const StrokeRaster::Place& from,
                const StrokeRaster::Place& to) {
    const auto value = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < mask.size.x && j < mask.size.y ? mask.at(i, j) : 0.0F;
    };
    Passed passed;
    float core = 0;
    float fringe = 0;
    const int places = 2 + int(std::ceil(4 * glm::length(to.pixel - from.pixel) / kRasterPitch));
    for (int n = 0; n < places; ++n) {
        const double s = double(n) / (places - 1);
        const glm::dvec2 shift = (glm::mix(from.pixel, to.pixel, s) + mask.origin) / kRasterPitch;
        const glm::ivec2 whole(glm::floor(shift));
        const glm::vec2 f(shift - glm::dvec2(whole));
        const glm::ivec2 c = e - whole;
        const float covered = glm::mix(glm::mix(value(c.x, c.y), value(c.x - 1, c.y), f.x),
                                       glm::mix(value(c.x, c.y - 1), value(c.x - 1, c.y - 1), f.x), f.y);
        const auto depth = float(glm::mix(from.depth, to.depth, s));
        if (covered > 0 && depth > 0) {
            passed.mask = std::max(passed.mask, covered);
            float& deepest = covered >= 0.5F ? core : fringe;
            deepest = std::max(deepest, depth);
        }
    }
    passed.depth = core > 0 ? core : fringe;
    return passed;
}

TEST(StrokeRaster, LongWaysAndLargeMasksAreCoveredAsByLookingAtEveryPlace) {
    std::mt19937 random(20);
    const auto upTo = [&](double most) { return std::uniform_real_distribution<>(0, most)(random); };
    for (int round = 0; round < 60; ++round) {
        sculpt::Outline outline; // a star with holes by the even-odd rule, of any size
        const double radius = 1 + upTo(20);
        for (int n = 0; n < 7; ++n) {
            const double angle = n * 2.7 + upTo(0.5);
            outline.push_back((0.3 + upTo(0.7)) * radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        const sculpt::MaskRaster mask = sculpt::rasterize(outline, kRasterPitch);
        const StrokeRaster::Place from{{upTo(30), upTo(30)}, upTo(9) - 1, {0, 0, 1}};
        const StrokeRaster::Place to{{upTo(30), upTo(30)}, upTo(9) - 1, {0, 0, 1}};
        StrokeRaster raster(kRasterPitch);
        const ElementBox changed = raster.cover(mask, sculpt::flatness(mask), from, to, kEverywhere);
        const ElementBox box = changed.isEmpty() ? ElementBox{{-60, -60}, {120, 120}}
                                                 : ElementBox{changed.lo - 3, changed.hi + 3};
        const StrokeRaster::Part part = raster.part(box);
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            for (int x = box.lo.x; x < box.hi.x; ++x) {
                const Passed passed = passedAt({x, y}, mask, from, to);
                const std::size_t n =
                    std::size_t(y - box.lo.y) * std::size_t(box.size().x) + std::size_t(x - box.lo.x);
                ASSERT_NEAR(part.mask.values[n], passed.mask, 1e-6F) << x << " " << y << " of " << round;
                ASSERT_NEAR(part.depths[n], passed.depth, 1e-5F) << x << " " << y << " of " << round;
            }
        }
    }
}

TEST(StrokeRaster, OnlyWhatLiesWithinIsTouched) {
    const auto mask = sculpt::rasterize(sculpt::circleOutline({0, 0}, 9), kRasterPitch);
    const auto flat = sculpt::flatness(mask);
    const StrokeRaster::Place from{{3, 4}, 2, {0, 0, 1}};
    const StrokeRaster::Place to{{30, 9}, 5, {0, 0, 1}};
    StrokeRaster whole(kRasterPitch);
    const ElementBox all = whole.cover(mask, flat, from, to, kEverywhere);
    const ElementBox window{all.lo + 7, all.hi - 6};
    StrokeRaster some(kRasterPitch);
    const ElementBox changed = some.cover(mask, flat, from, to, window);
    EXPECT_EQ(changed.lo, window.lo);
    EXPECT_EQ(changed.hi, window.hi);
    EXPECT_EQ(some.part(window).mask.values, whole.part(window).mask.values);
    EXPECT_EQ(some.part(window).depths, whole.part(window).depths);
    EXPECT_TRUE(some.cover(mask, flat, from, to, {{900, 900}, {910, 910}}).isEmpty());
}

} // namespace
} // namespace vs::studio
