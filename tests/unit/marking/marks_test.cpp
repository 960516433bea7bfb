// SPDX-License-Identifier: Apache-2.0
// Bricks of marks: what is shared, what differs, what a place has.
#include "field/marks/marks.h"
#include "property.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace vs::field {
namespace {

MarkGrid someGrid() { return {{40, 30, 20}, {2, 2, 4}}; }

Marks::Brick brickOf(std::uint8_t coverage, int at) {
    auto brick = std::make_shared<MarkBrick>();
    brick->set(std::size_t(at), {1, 2, 3, 255, coverage});
    return brick;
}

TEST(MarksTest, TexelsAreAboutHalfAStepWideAlongEachAxis) {
    volume::GridGeometry geometry;
    geometry.dims = {100, 120, 30};
    geometry.worldFromVoxel = glm::dmat4(1);
    geometry.worldFromVoxel[2][2] = 5; // slices five times as far apart as pixels
    const MarkGrid grid = markGridOf(geometry);
    EXPECT_EQ(grid.perVoxel, glm::ivec3(2, 2, 10));
    EXPECT_EQ(grid.texelMm(geometry), 0.5);
    geometry.dims = {1000, 120, 30};
    EXPECT_EQ(markGridOf(geometry).perVoxel, glm::ivec3(1, 1, 5)) << "large scans have coarser ones";
}

TEST(MarksTest, PlacesOfTexelsAndVoxelsAreOneAnothers) {
    const MarkGrid grid = someGrid();
    for (const glm::dvec3 p : {glm::dvec3(0), glm::dvec3(-0.5), glm::dvec3(3.25, 7, 19.5)}) {
        EXPECT_LT(glm::distance(grid.voxelFromTexel(grid.texelFromVoxel(p)), p), 1e-12);
    }
    const glm::ivec3 n = grid.bricks();
    for (std::uint32_t place = 0; place < std::uint32_t(n.x * n.y * n.z); ++place) {
        EXPECT_EQ(grid.placeOf(grid.brickAt(place)), place);
    }
}

// Against a map from places to bricks: random edits, each of several bricks at once.
TEST(MarksTest, EditsAreThoseOfAMapAndShareTheRest) {
    test::checkProperty(50, [] {
        std::map<std::uint32_t, Marks::Brick> model;
        Marks marks(someGrid(), {});
        for (int edit = 0; edit < 12; ++edit) {
            std::map<std::uint32_t, Marks::Brick> changed;
            for (int n = *test::below(5); n >= 0; --n) {
                const auto place = std::uint32_t(*test::below(40));
                changed[place] = *test::below(3) == 0 ? nullptr : brickOf(std::uint8_t(*test::below(3)), 7);
            }
            const Marks after = marks.with({changed.begin(), changed.end()});
            for (const auto& [place, brick] : changed) {
                if (brick && !brick->isEmpty()) {
                    model[place] = brick;
                } else {
                    model.erase(place);
                }
            }
            RC_ASSERT(std::map(after.bricks().begin(), after.bricks().end()) == model);
            const auto places = changedBricks(marks, after);
            RC_ASSERT(std::is_sorted(places.begin(), places.end()));
            for (std::uint32_t place = 0; place < 40; ++place) {
                const bool isNamed = std::find(places.begin(), places.end(), place) != places.end();
                RC_ASSERT(isNamed == (marks.find(place) != after.find(place)));
            }
            marks = after;
        }
    });
}

// Texels on the faces of bricks are seen beyond them, too.
TEST(MarksTest, AChangeNamesTheVoxelsWhoseColoursDiffer) {
    test::checkProperty(60, [] {
        const MarkGrid grid = someGrid();
        const glm::ivec3 n = grid.bricks();
        const glm::ivec3 brick(*test::below(n.x - 1), *test::below(n.y - 1), *test::below(n.z - 1));
        glm::ivec3 inside(0);
        for (int axis = 0; axis < 3; ++axis) {
            inside[axis] = std::array{0, 1, 7, 14, 15}[std::size_t(*test::below(5))];
        }
        const Marks before(grid, {});
        const Marks after = before.with({{grid.placeOf(brick), brickOf(255, int(MarkBrick::index(inside)))}});
        const Box3 box = changedBetween(before, after);
        int seen = 0;
        for (int i = 0; i < 300; ++i) { // about the texel
            const glm::dvec3 texel = glm::dvec3(brick * kMarkBrick + inside) +
                                     glm::dvec3(*test::below(25), *test::below(25), *test::below(25)) / 10.0 -
                                     1.2;
            const glm::dvec3 p = grid.voxelFromTexel(texel);
            if (before.colourAt(p) != after.colourAt(p)) {
                ++seen;
                for (const glm::dvec3 voxel : {glm::floor(p + 0.5), glm::ceil(p - 0.5)}) {
                    const glm::ivec3 v = glm::clamp(glm::ivec3(voxel), glm::ivec3(0), grid.dims - 1);
                    RC_ASSERT(glm::all(glm::greaterThanEqual(v, box.lo)));
                    RC_ASSERT(glm::all(glm::lessThan(v, box.hi)));
                }
            }
        }
        RC_ASSERT(seen > 0);
    });
}

TEST(MarksTest, VoxelsHaveTheMeanOfTheirTexels) {
    const MarkGrid grid{{16, 16, 16}, {2, 2, 2}};
    auto brick = std::make_shared<MarkBrick>();
    for (int i = 0; i < 2; ++i) { // two of the eight texels of voxel (1, 0, 0)
        brick->set(MarkBrick::index({2 + i, 0, 0}), {std::uint8_t(100 + 100 * i), 0, 50, 255, 255});
    }
    const auto colours = coloursOfVoxels(Marks(grid, {{0, brick}}));
    EXPECT_EQ(colours[1], (std::array<std::uint8_t, 4>{150, 0, 50, 64}));
    EXPECT_EQ(std::count(colours.begin(), colours.end(), std::array<std::uint8_t, 4>{}),
              std::ptrdiff_t(colours.size()) - 1);
}

} // namespace
} // namespace vs::field
