// SPDX-License-Identifier: Apache-2.0
#include "render/colours/colour.h"
#include "render/colours/segment_palette.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vs::render {
namespace {

glm::dvec3 labOf(int label) { return oklabFromLinear(linearFromDisplay(segmentColour(label))); }

double leastDistance(int apart) {
    double least = 1e30;
    for (int label = 1; label + apart <= 255; ++label) {
        least = std::min(least, glm::distance(labOf(label), labOf(label + apart)));
    }
    return least;
}

// A just noticeable difference is about 0.02 in OKLab.
TEST(SegmentPalette, LabelsThatFollowOneAnotherAreFarApart) {
    for (int apart = 1; apart <= 8; ++apart) {
        EXPECT_GT(leastDistance(apart), 0.08) << apart;
    }
}

TEST(SegmentPalette, NoTwoAreTheSame) {
    double least = 1e30;
    for (int a = 1; a <= 255; ++a) {
        for (int b = 1; b < a; ++b) {
            least = std::min(least, glm::distance(labOf(a), labOf(b)));
        }
    }
    EXPECT_GT(least, 0.02);
}

TEST(SegmentPalette, NoneIsAsDarkAsTheBackgroundOrAsPaleAsBone) {
    for (int label = 1; label <= 255; ++label) {
        const glm::dvec3 lab = labOf(label);
        EXPECT_GT(lab.x, 0.4) << label;
        EXPECT_GT(std::hypot(lab.y, lab.z), 0.06) << label;
    }
}

} // namespace
} // namespace vs::render
