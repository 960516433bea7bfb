// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "sculpt/radiation/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vs::sculpt {
namespace {

constexpr double kWindowPitch = 0.5;

SweepGrid gridOf(const glm::ivec3& dims, const glm::dvec3& spacing = glm::dvec3(1)) {
    return sweepGrid(dims, sweepFootprint(3, spacing), voxelFromSteps(spacing));
}

MaskFrame randomFrame(std::mt19937& random, double spread) {
    std::normal_distribution<> any;
    const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
    return frameFacing(glm::dvec3(16) + spread * vector(), vector());
}

TEST(SweepWindow, HoldsAllThatComesIntoTheGrid) {
    std::mt19937 random(1);
    std::uniform_real_distribution<> share;
    for (int round = 0; round < 200; ++round) {
        const SweepGrid grid = gridOf({32, 20, 40}, {1, 1, 1 + 3 * share(random)});
        const MaskWindow mask{{-1000 * share(random), -3}, {40, 500 * share(random)}};
        PathPiece piece{randomFrame(random, 30), {}};
        piece.to = piece.from;
        piece.to.origin += 20 * share(random) * glm::cross(piece.from.x, piece.from.y);
        const MaskWindow found = windowInto(grid, mask, piece);
        for (int n = 0; n < 3000; ++n) {
            const glm::dvec2 element = glm::mix(mask.lo, mask.hi, glm::dvec2(share(random), share(random)));
            const glm::dvec3 p = grid.voxelFromSteps *
                                 glm::mix(piece.from.place(element), piece.to.place(element), share(random));
            if (glm::all(glm::greaterThanEqual(p, glm::dvec3(grid.lo))) &&
                glm::all(glm::lessThanEqual(p, glm::dvec3(grid.hi)))) {
                ASSERT_TRUE(glm::all(glm::lessThanEqual(found.lo, element)) &&
                            glm::all(glm::greaterThanEqual(found.hi, element)))
                    << round;
            }
        }
        if (!found.isEmpty()) { // and little more: the grid's diagonal, and what is left when halving
            EXPECT_LT(std::max(found.hi.x - found.lo.x, found.hi.y - found.lo.y), 2.5 * 180) << round;
        }
    }
}

// A mask of what comes into the grid is there as the whole one.
TEST(SweepWindow, WhatIsCutOffAnOutlineDoesNotMatter) {
    std::mt19937 random(2);
    std::uniform_real_distribution<> share;
    MaskFilter filter;
    filter.sampling = Sampling::PolygonSmooth; // exact wherever the raster begins
    for (int round = 0; round < 40; ++round) {
        const SweepGrid grid = gridOf(glm::ivec3(24));
        const Outline outline = starOutline({20 * share(random), 10 * share(random)}, 150, 40, 5);
        PathPiece piece{randomFrame(random, 10), {}};
        piece.to = piece.from;
        piece.to.origin += 4.0 * glm::cross(piece.from.x, piece.from.y);
        const MaskRaster whole = rasterize(outline, kWindowPitch, filter);
        const MaskRaster part = rasterize(
            outlineInto(grid, outline, std::span(&piece, 1), kWindowPitch, filter), kWindowPitch, filter);
        const MaskElements needed = elementsInto(grid, whole, piece);
        ASSERT_LT(part.values.size(), whole.values.size());
        for (int j = needed.lo.y; j < needed.hi.y; ++j) {
            for (int i = needed.lo.x; i < needed.hi.x; ++i) {
                const glm::dvec3 p = piece.from.place(whole.origin + whole.pitch * glm::dvec2(i, j));
                const bool isIn = glm::all(glm::greaterThanEqual(p, glm::dvec3(grid.lo))) &&
                                  glm::all(glm::lessThanEqual(p, glm::dvec3(grid.hi)));
                const glm::ivec2 e =
                    glm::ivec2(glm::round((whole.origin - part.origin) / whole.pitch)) + glm::ivec2(i, j);
                const bool isThere = e.x >= 0 && e.y >= 0 && e.x < part.size.x && e.y < part.size.y;
                if (isIn) {
                    ASSERT_NEAR(isThere ? part.at(e.x, e.y) : 0.0F, whole.at(i, j), 1e-5F) << round;
                }
            }
        }
    }
}

TEST(SweepWindow, PathsAreFineNearTheGridAndCoarseBeyond) {
    const PathRegion region{{860, -60, 0}, {940, 60, 100}, 5};
    const Helix wide{{0, 0, 50}, {0, 0, 60}, 900, 20}; // a little of each turn is in the region
    const auto all = helixPath(wide);
    const auto some = helixPath(wide, FrameKind::ParallelTransport, region);
    EXPECT_LT(some.size(), 0.3 * double(all.size()));
    EXPECT_LT(glm::length(some.back().to.origin - all.back().to.origin), 1e-9);
    EXPECT_LT(glm::length(some.back().to.x - all.back().to.x), 1e-3); // turned as far about its way
    std::size_t n = 0; // each fine chord in the region is there
    for (const PathPiece& piece : all) {
        if (!region.mayHold(piece.from.origin, 0)) {
            continue;
        }
        while (n < some.size() && glm::length(some[n].from.origin - piece.from.origin) > 1e-9) {
            ++n;
        }
        ASSERT_LT(n, some.size());
        EXPECT_LT(glm::length(some[n].to.origin - piece.to.origin), 1e-9);
    }
    // Far away a path of five million steps is a few turns.
    const std::vector<glm::dvec3> far{{1e5, 0, 0}, {0, 1e5, 0}, {-1e5, 0, 9e4}, {0, -1e5, 0}};
    EXPECT_LT(splinePath(far, FrameKind::Frenet, region).size(), 400U);
    EXPECT_LT(helixPath({{0, 0, 0}, {1, 1, 1}, 4096, 1000}, FrameKind::ParallelTransport, region).size(),
              130000U);
    EXPECT_THROW(helixPath({{0, 0, 0}, {1, 1, 1}, 4096, 1000}), Error); // fine everywhere
}

TEST(SweepWindow, MasksKnowWhereTheyAreFlat) {
    std::mt19937 random(3);
    std::uniform_real_distribution<> share;
    for (int round = 0; round < 30; ++round) {
        const MaskRaster mask =
            rasterize(starOutline({0, 0}, 4 + 20 * share(random), 3, 3 + round % 5), kWindowPitch);
        const auto flat = flatness(mask);
        const auto value = [&](int i, int j) {
            return i >= 0 && j >= 0 && i < mask.size.x && j < mask.size.y ? mask.at(i, j) : 0.0F;
        };
        int largest = 0;
        for (int j = 0; j < mask.size.y; j += 2) {
            for (int i = 0; i < mask.size.x; i += 3) {
                const int around =
                    std::min<int>(flat[std::size_t(j) * std::size_t(mask.size.x) + std::size_t(i)], 60);
                largest = std::max(largest, around);
                for (int k = -around; k <= around; ++k) {
                    for (const glm::ivec2 e :
                         {glm::ivec2(k, around), {k, -around}, {around, k}, {-around, k}}) {
                        ASSERT_EQ(value(i + e.x, j + e.y), mask.at(i, j)) << round;
                    }
                }
            }
        }
        EXPECT_GE(largest, 2) << round;
    }
}

} // namespace
} // namespace vs::sculpt
