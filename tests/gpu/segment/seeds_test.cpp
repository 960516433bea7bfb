// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/seeds.h"

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
    const auto volume = volume::makePhantom(
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
        volume::makePhantom({8, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3) { return 50.0; });
    const field::Field field = field::uploadVolume(volume);
    Constraints constraints;
    constraints.range = {0, 100};
    std::vector<field::SurfacePoint> points(300 * 200);
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

} // namespace
} // namespace vs::segment
