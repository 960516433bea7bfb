// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/growth/growth.h"
#include "segment/growth/seeds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace vs::segment {
namespace {

using SeedsTest = test::GlTest;

field::SurfacePoints upload(const std::vector<field::SurfacePoint>& points, glm::ivec2 size) {
    field::SurfacePoints out;
    out.size = size;
    out.points = gl::Buffer(points.size() * sizeof(field::SurfacePoint), "test points");
    out.points.write(std::span<const field::SurfacePoint>(points));
    return out;
}

TEST_F(SeedsTest, EachHitBecomesTheNearestVoxelInRangeOnce) {
    const glm::ivec3 dims(30, 20, 25);
    const glm::dvec3 spacing(1, 0.5, 2);
    std::mt19937 random(11);
    const auto volume = phantom::makePhantom(
        dims, volume::ScalarType::UInt8, [&](glm::dvec3) { return double(random() % 100); }, spacing);
    const field::Field field = field::uploadVolume(volume);
    gl::Texture sculpture(dims, gl::Format::R8, gl::Filter::Linear, "test sculpture");
    std::vector<std::uint8_t> cut(volume.geometry.voxelCount());
    std::generate(cut.begin(), cut.end(), [&] { return std::uint8_t(random() % 3 == 0 ? 255 : 0); });
    sculpture.upload({glm::ivec3(0), dims}, std::as_bytes(std::span(cut)));

    const glm::ivec2 size(97, 61);
    std::vector<field::SurfacePoint> points(std::size_t(size.x) * std::size_t(size.y));
    std::uniform_real_distribution<float> place(-0.5F, 1.0F);
    for (auto& point : points) { // some lie half a voxel outside the outermost centres
        point.voxel = {place(random) * 29.4F, place(random) * 19.4F, place(random) * 24.4F,
                       random() % 4 == 0 ? 0 : 1};
        point.voxel = glm::max(point.voxel, glm::vec4(-0.49F, -0.49F, -0.49F, 0));
    }
    SeedFinder finder;
    for (const auto view :
         {field::SculptureView::Whole, field::SculptureView::Cut, field::SculptureView::Probe}) {
        Constraints constraints;
        constraints.range = {30, 60};
        constraints.sculpture = &sculpture;
        constraints.view = view;
        const auto admitted = admits(volume, constraints, cut);
        std::set<std::array<int, 3>> expected; // z, y, x
        for (const auto& point : points) {
            const glm::ivec3 cell(glm::floor(glm::vec3(point.voxel)));
            double nearest = std::numeric_limits<double>::infinity();
            std::array<int, 3> best{};
            for (int corner = 0; corner < 8 && point.voxel.w > 0.5F; ++corner) {
                const glm::ivec3 v = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
                if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, dims)) ||
                    !admitted(v)) {
                    continue;
                }
                const double distance = glm::length((glm::dvec3(v) - glm::dvec3(point.voxel)) * spacing);
                if (distance < nearest) {
                    nearest = distance;
                    best = {v.z, v.y, v.x};
                }
            }
            if (std::isfinite(nearest)) {
                expected.insert(best);
            }
        }
        const auto found = finder.find(upload(points, size), field, constraints);
        ASSERT_EQ(found.size(), expected.size());
        auto next = expected.begin();
        for (const glm::ivec3 v : found) {
            EXPECT_EQ((std::array<int, 3>{v.z, v.y, v.x}), *next++);
        }
        EXPECT_GT(found.size(), 100U);
    }
}

TEST_F(SeedsTest, ManyHitsOnOneVoxelGiveOneSeed) {
    const auto volume =
        phantom::makePhantom({8, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3) { return 50.0; });
    const field::Field field = field::uploadVolume(volume);
    Constraints constraints;
    constraints.range = {0, 100};
    std::vector<field::SurfacePoint> points(std::size_t(300) * 200);
    for (auto& point : points) {
        point.voxel = {3.2F, 4.1F, 6.9F, 1};
    }
    SeedFinder finder;
    EXPECT_EQ(finder.find(upload(points, {300, 200}), field, constraints),
              (std::vector<glm::ivec3>{{3, 4, 7}}));
    points[7].voxel = {1.5F, 2, 3, 1}; // of equally near voxels the first in the grid's order
    EXPECT_EQ(finder.find(upload(points, {300, 200}), field, constraints),
              (std::vector<glm::ivec3>{{1, 2, 3}, {3, 4, 7}}));
    for (auto& point : points) {
        point.voxel.w = 0;
    }
    EXPECT_TRUE(finder.find(upload(points, {300, 200}), field, constraints).empty());
}

// More than one row of 65535 groups of 64: a filled sketch on a screen of 4K gives as many.
TEST_F(SeedsTest, FiveMillionHitsAreAllLookedAt) {
    const int side = 32;
    const auto volume =
        phantom::makePhantom(glm::ivec3(side), volume::ScalarType::UInt8, [](glm::dvec3) { return 50.0; });
    const field::Field field = field::uploadVolume(volume);
    Constraints constraints;
    constraints.range = {0, 100};
    const glm::ivec2 size(2500, 2000);
    std::vector<field::SurfacePoint> points(std::size_t(size.x) * std::size_t(size.y));
    const auto place = [&](std::size_t voxel) {
        return glm::vec4(voxel % side, voxel / side % side, voxel / side / side, 1);
    };
    // One hit each at the very ends of the list and of its first row; nothing between them.
    const std::vector<std::size_t> hits{0, 1, std::size_t(65535) * 64 - 1, std::size_t(65535) * 64,
                                        points.size() - 1};
    std::vector<glm::ivec3> expected;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        points[hits[i]].voxel = place(1000 * i);
        expected.emplace_back(place(1000 * i));
    }
    SeedFinder finder;
    EXPECT_EQ(finder.find(upload(points, size), field, constraints), expected);
}

TEST_F(SeedsTest, FiveMillionVoxelsCanBeSeeds) {
    const glm::ivec3 dims(172); // 5.09 million
    const auto volume =
        phantom::makePhantom(dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 50.0; });
    const field::Field field = field::uploadVolume(volume);
    std::vector<glm::ivec3> seeds;
    for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
        seeds.emplace_back(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
    }
    seeds.pop_back(); // the last voxel is left to grow
    Constraints constraints;
    constraints.range = {0, 100};
    Growth growth(field);
    growth.setConstraints(constraints);
    EXPECT_EQ(growth.addSeeds(std::span(&seeds.front(), 1)).added, 1);
    EXPECT_EQ(growth.advance(1), 1); // from here on seeds are put into the frontier one by one
    const auto counts = growth.addSeeds(seeds);
    EXPECT_EQ(counts.added, int(seeds.size()) - 4);
    EXPECT_EQ(counts.present, 4);
    EXPECT_EQ(growth.voxelCount(), seeds.size());
    // Only a seed from the list's end has the last voxel for a neighbour.
    EXPECT_EQ(growth.advance(5), 1);
    const auto generations = growth.generations(true);
    EXPECT_EQ(std::count(generations.begin(), generations.end(), 0U), 0);
    EXPECT_EQ(generations.back(), std::uint32_t(growth.playhead()));
}

} // namespace
} // namespace vs::segment
