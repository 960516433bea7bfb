// SPDX-License-Identifier: Apache-2.0
// Where a vessel is narrow for its surroundings, of diameters that are given; vessel_test.cpp has measured
// ones.
#include "segment/measures/narrowest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vs::segment {
namespace {

Vessel vesselOf(double lengthMm, const std::function<double(double)>& diameter) {
    Vessel vessel{{}, lengthMm};
    for (double along = 0; along <= lengthMm; along += 0.5) {
        vessel.points.push_back({glm::dvec3(along, 0, 0), along, diameter(along), diameter(along)});
    }
    return vessel;
}

TEST(Narrowest, TaperIsNoStenosis) {
    const auto found = narrowestOf(vesselOf(80, [](double along) { return 8 - 0.05 * along; }));
    ASSERT_TRUE(found);
    EXPECT_LT(found->stenosisPercent, 1);
    EXPECT_FALSE(narrowestOf(vesselOf(10, [](double) { return 6.0; }))) << "too short to tell";
}

TEST(Narrowest, BulgesHaveNoSay) {
    const auto found = narrowestOf(vesselOf(90, [](double along) {
        const bool isBulge = std::abs(along - 20) < 4;
        return std::abs(along - 45) < 4 ? 3.0 : isBulge ? 12.0 : 6.0;
    }));
    ASSERT_TRUE(found);
    EXPECT_NEAR(double(found->index), 90, 1);
    EXPECT_NEAR(found->stenosisPercent, 50, 0.1);
}

} // namespace
} // namespace vs::segment
