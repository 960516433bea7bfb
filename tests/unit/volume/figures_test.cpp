// SPDX-License-Identifier: Apache-2.0
// Lengths, angles and areas against closed forms, on voxels of any size and direction.
#include "volume/measures/figures.h"

#include "phantom/phantom.h"
#include "property.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vs::volume {
namespace {

// A slanted grid of values that rise by two a voxel along x, and by a tenth along y.
Volume ramp(glm::dvec3 spacing) {
    Volume volume = phantom::makePhantom(
        {64, 48, 20}, ScalarType::Float32, [](glm::dvec3 voxel) { return 2 * voxel.x + 0.1 * voxel.y; },
        spacing);
    volume.geometry.worldFromVoxel = glm::rotate(glm::dmat4(1), 0.4, glm::normalize(glm::dvec3(1, -2, 0.5))) *
                                     volume.geometry.worldFromVoxel;
    return volume;
}

const std::vector<glm::dvec3> kSpacings{{1, 1, 1}, {1, 1, 3}, {0.4, 0.7, 2}};

// An ellipse on a slice: radii in mm along the other two axes.
std::vector<glm::dvec3> ellipse(int axis, glm::dvec3 middle, glm::dvec2 radiiMm, glm::dvec3 spacing) {
    constexpr int kCorners = 400;
    std::vector<glm::dvec3> outline;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * glm::pi<double>() * i / kCorners;
        glm::dvec3 point = middle;
        const int across = (axis + 1) % 3;
        const int down = (axis + 2) % 3;
        point[across] += radiiMm.x * std::cos(angle) / spacing[across];
        point[down] += radiiMm.y * std::sin(angle) / spacing[down];
        outline.push_back(point);
    }
    return outline;
}

TEST(Figures, LengthsAndAnglesAreThoseOfTheWorld) {
    const std::vector<glm::dvec3> stairs{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {3, 4, 12}};
    EXPECT_DOUBLE_EQ(lengthMm(stairs), 19);
    EXPECT_DOUBLE_EQ(lengthMm(std::span(stairs).first(1)), 0);
    EXPECT_NEAR(angleDegrees({1, 0, 0}, {0, 0, 0}, {0, 0, 2}), 90, 1e-12);
    EXPECT_NEAR(angleDegrees({1, 1, 1}, {1, 1, 2}, {1, 1, 3}), 180, 1e-12);
    const double small = 1e-7;
    EXPECT_NEAR(angleDegrees({1, 0, 0}, {0, 0, 0}, {std::cos(small), std::sin(small), 0}),
                glm::degrees(small), 1e-15);
    EXPECT_EQ(angleDegrees({1, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0);
}

TEST(Figures, AreasOfEllipsesAndTheValuesInThem) {
    for (const glm::dvec3& spacing : kSpacings) {
        const Volume volume = ramp(spacing);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 middle(31.5, 23.5, 9.5);
            glm::dvec3 onSlice = middle;
            onSlice[axis] = std::floor(middle[axis]);
            const glm::dvec3 size = 0.8 * middle * spacing;
            const glm::dvec2 radii(size[(axis + 1) % 3], size[(axis + 2) % 3]);
            const auto outline = ellipse(axis, onSlice, radii, spacing);
            ASSERT_EQ(sliceAxis(outline), axis);
            const UnderOutline under = underOutline(volume, outline);
            const double area = glm::pi<double>() * radii.x * radii.y;
            EXPECT_NEAR(under.mm2 / area, 1, 1e-3);
            const double mm2OfAVoxel = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
            EXPECT_NEAR(double(under.voxels) * mm2OfAVoxel / area, 1, 0.03)
                << "voxels along a border are in or out";
            // Middle and spread of a ramp over an ellipse: half a radius along each axis.
            const double mean = 2 * onSlice.x + 0.1 * onSlice.y;
            EXPECT_NEAR(under.mean, mean, 0.02 * mean);
            const glm::dvec3 halfRadii = 0.4 * middle * glm::dvec3(axis != 0, axis != 1, axis != 2);
            EXPECT_NEAR(under.deviation, std::hypot(2 * halfRadii.x, 0.1 * halfRadii.y),
                        0.03 * (2 * halfRadii.x + 0.1 * halfRadii.y));
            EXPECT_LT(under.smallest, under.mean);
            EXPECT_GT(under.largest, under.mean);
        }
    }
}

// Voxels are counted one by one where a rectangle encloses their centres.
TEST(Figures, RectanglesEncloseTheCentresThatLieInThem) {
    const Volume volume = ramp({1, 1, 3});
    test::checkProperty(300, [&] {
        const double x0 = *test::between(-5, 60);
        const double y0 = *test::between(-5, 40);
        const double x1 = x0 + *test::between(0.3, 30);
        const double y1 = y0 + *test::between(0.3, 30);
        const double z = *test::between(0, 19);
        std::vector<glm::dvec3> outline{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
        if (*test::coin()) {
            std::reverse(outline.begin(), outline.end());
        }
        const UnderOutline under = underOutline(volume, outline);
        std::size_t voxels = 0;
        double sum = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                if (x >= x0 && x < x1 && y >= y0 && y < y1) {
                    ++voxels;
                    sum += volume.at({x, y, int(std::lround(z))});
                }
            }
        }
        RC_ASSERT(under.voxels == voxels);
        RC_ASSERT(
            (voxels == 0 ? std::isnan(under.mean) : std::abs(under.mean - sum / double(voxels)) < 1e-9));
        RC_ASSERT(std::abs(under.mm2 - (x1 - x0) * (y1 - y0)) < 1e-9);
    });
}

TEST(Figures, WhatIsNoNumberIsLeftOut) {
    Volume volume = phantom::makePhantom({8, 8, 1}, ScalarType::Float32, [](glm::dvec3 p) {
        return p.x < 3 ? std::numeric_limits<double>::quiet_NaN() : 7.0;
    });
    const auto outline = std::vector<glm::dvec3>{{-1, -1, 0}, {9, -1, 0}, {9, 9, 0}, {-1, 9, 0}};
    EXPECT_EQ(underOutline(volume, outline).voxels, 40U);
    EXPECT_EQ(underOutline(volume, outline).mean, 7);
    EXPECT_EQ(underOutline(volume, outline).deviation, 0);
}

TEST(Figures, AnOutlineThatLeavesItsSliceLiesInNone) {
    EXPECT_EQ(sliceAxis(std::vector<glm::dvec3>{{0, 0, 4}, {5, 1, 4.2}, {2, 3, 4}}), -1);
    EXPECT_EQ(sliceAxis(std::vector<glm::dvec3>{{2, 0, 4}, {2, 1, 4.2}, {2.001, 3, 4}}), 0);
}

} // namespace
} // namespace vs::volume
