// SPDX-License-Identifier: Apache-2.0
#include "field/cell_ranges.h"
#include "tool_fixture.h"

#include <random>

namespace vs::sculpt {
namespace {

using SculptureTest = test::GlTest;
using test::drill;
using test::Workpiece;

const glm::ivec3 kSculptureDims(75, 61, 50); // no multiple of a tile, a cell or a brick

// Every cell's range must be the one of its 5^3 corner voxels.
void expectCellsRight(const Sculpture& sculpture) {
    const auto values = sculpture.values({glm::ivec3(0), sculpture.dims()});
    const auto cells = sculpture.cells().downloadAll<glm::vec2>();
    const glm::ivec3 dims = sculpture.dims();
    const glm::ivec3 count = field::cellDims(dims);
    std::size_t n = 0;
    for (int z = 0; z < count.z; ++z) {
        for (int y = 0; y < count.y; ++y) {
            for (int x = 0; x < count.x; ++x, ++n) {
                const glm::ivec3 first = glm::ivec3(x, y, z) * field::kCell;
                const glm::ivec3 last = glm::min(first + field::kCell, dims - 1);
                glm::vec2 range(1e9F, -1e9F);
                for (int k = first.z; k <= last.z; ++k) {
                    for (int j = first.y; j <= last.y; ++j) {
                        for (int i = first.x; i <= last.x; ++i) {
                            const float v = values[std::size_t((k * dims.y + j) * dims.x + i)];
                            range = {std::min(range.x, v), std::max(range.y, v)};
                        }
                    }
                }
                ASSERT_EQ(cells[n], range) << x << " " << y << " " << z;
            }
        }
    }
}

TEST_F(SculptureTest, CellsFollowEveryChange) {
    Workpiece piece(kSculptureDims);
    const auto mask = rasterize(ellipseOutline({40, 30}, {20, 9}), 0.5);
    BrickBackup backup(piece.sculpture.texels());
    const auto before = piece.sculpture.version();
    const Box3 box = piece.cut(test::slabUnder(mask, 20), mask, drill(15, {0.3, 0.2, 1}), &backup);
    EXPECT_GT(piece.sculpture.version(), before);
    EXPECT_FALSE(piece.sculpture.isEmpty());
    expectCellsRight(piece.sculpture);
    auto delta = backup.finish();
    piece.sculpture.swap(delta);
    expectCellsRight(piece.sculpture);
    piece.sculpture.swap(delta);
    const auto bytes = piece.sculpture.download(box);
    piece.sculpture.clear();
    EXPECT_TRUE(piece.sculpture.isEmpty());
    expectCellsRight(piece.sculpture);
    piece.sculpture.upload(box, bytes);
    expectCellsRight(piece.sculpture);
}

TEST_F(SculptureTest, ChangesAndTouchedBricksAreKnownForEver) {
    Sculpture sculpture({200, 40, 40});
    const auto write = [&](int x) {
        const Box3 box{{x, 1, 1}, {x + 2, 3, 3}};
        sculpture.upload(box, std::vector<std::byte>(box.volume() * 2, std::byte(0x3b)));
        return box;
    };
    EXPECT_TRUE(sculpture.touchedBricks().empty());
    const Box3 first = write(100);
    const auto afterFirst = sculpture.version();
    for (int n = 0; n < 100; ++n) {
        write(10 + n % 7);
    }
    const auto afterMany = sculpture.version();
    const Box3 last = write(180);
    EXPECT_EQ(sculpture.changedSince(afterMany), last);
    EXPECT_TRUE(sculpture.changedSince(sculpture.version()).isEmpty());
    const Box3 most = sculpture.changedSince(afterFirst);
    EXPECT_EQ(intersect(most, last), last);
    EXPECT_LE(most.lo.x, 10);
    EXPECT_EQ(intersect(sculpture.changedSince(0), first), first);
    const auto bricks = sculpture.touchedBricks();
    ASSERT_EQ(bricks.size(), 3U);
    EXPECT_EQ(bricks[1], (Box3{{96, 0, 0}, {128, 32, 32}}));
    EXPECT_EQ(bricks[2], (Box3{{160, 0, 0}, {192, 32, 32}}));
    const auto before = sculpture.version();
    sculpture.clear();
    EXPECT_EQ(intersect(sculpture.changedSince(before), first), first) << "clearing is a change too";
    EXPECT_TRUE(sculpture.touchedBricks().empty());
    EXPECT_TRUE(sculpture.isEmpty());
    expectCellsRight(sculpture);
    for (const float value : sculpture.values({glm::ivec3(0), sculpture.dims()})) {
        ASSERT_EQ(value, 0.0F);
    }
}

TEST_F(SculptureTest, OnlyTheReturnedBoxChangesAndItIsTight) {
    Workpiece piece(kSculptureDims);
    const auto mask = rasterize(circleOutline({40, 30}, 6), 0.5);
    const Box3 box = piece.cut(test::slabUnder(mask, 20), mask, drill(10));
    const auto values = piece.values();
    Box3 changed;
    for (int z = 0; z < kSculptureDims.z; ++z) {
        for (int y = 0; y < kSculptureDims.y; ++y) {
            for (int x = 0; x < kSculptureDims.x; ++x) {
                if (values[std::size_t((z * kSculptureDims.y + y) * kSculptureDims.x + x)] != 0) {
                    changed = unite(changed, {{x, y, z}, {x + 1, y + 1, z + 1}});
                }
            }
        }
    }
    EXPECT_EQ(intersect(box, changed), changed);
    EXPECT_LE(box.volume(), grow(changed, 2 * kTile).volume());
}

TEST_F(SculptureTest, UndoAndRedoRestoreBytesExactly) {
    Workpiece piece(kSculptureDims);
    const auto first = rasterize(circleOutline({30, 30}, 10), 0.5);
    const auto second = rasterize(circleOutline({42, 33}, 12), 0.5);
    piece.cut(test::slabUnder(first, 15), first, drill(8));
    const auto before = piece.bytes();

    BrickBackup backup(piece.sculpture.texels());
    piece.cut(test::slabUnder(second, 12), second, drill(9), &backup);
    piece.cut(test::slabUnder(second, 12), second, drill(13), &backup);
    const auto after = piece.bytes();
    BrickDelta delta = backup.finish();
    EXPECT_TRUE(backup.isEmpty());

    std::size_t differing = 0;
    for (std::size_t n = 0; n < before.size(); n += 2) {
        differing += before[n] != after[n] || before[n + 1] != after[n + 1] ? 1 : 0;
    }
    EXPECT_EQ(delta.changedVoxels(), differing);
    EXPECT_GT(differing, 1000U);
    EXPECT_LT(delta.memoryBytes(), before.size() / 2);
    piece.sculpture.swap(delta);
    EXPECT_EQ(piece.bytes(), before);
    piece.sculpture.swap(delta);
    EXPECT_EQ(piece.bytes(), after);
    piece.sculpture.swap(delta);
    EXPECT_EQ(piece.bytes(), before);
}

TEST_F(SculptureTest, ABackupCanPutEverythingBack) {
    Workpiece piece(kSculptureDims);
    const auto mask = rasterize(circleOutline({42, 33}, 12), 0.5);
    BrickBackup backup(piece.sculpture.texels());
    const auto before = piece.bytes();
    piece.cut(test::slabUnder(mask, 12), mask, drill(9), &backup);
    piece.sculpture.refresh(backup.restore());
    EXPECT_EQ(piece.bytes(), before);
    expectCellsRight(piece.sculpture);
    // Back to the start is no change at all.
    EXPECT_TRUE(backup.finish().isEmpty());
}

TEST_F(SculptureTest, BricksAreProtectedOnceAndOnlyInsideTheTexture) {
    gl::Texture texture(glm::ivec3(40, 33, 20), gl::Format::R16UI, gl::Filter::Nearest, "labels");
    texture.clear(7U);
    BrickBackup backup(texture);
    backup.protect({{-10, 5, 5}, {5, 6, 6}});
    texture.clear({{0, 0, 0}, {3, 3, 3}}, 9U);
    backup.protect({{0, 0, 0}, {100, 100, 100}}); // the first brick keeps its first contents
    texture.clear({{39, 32, 19}, {40, 33, 20}}, 1U);
    backup.protect({{200, 0, 0}, {300, 1, 1}});
    BrickDelta delta = backup.finish();
    EXPECT_EQ(delta.changedVoxels(), 28U);
    EXPECT_EQ(delta.box(), (Box3{{0, 0, 0}, {40, 33, 20}}));
    delta.swap(texture);
    for (const auto value : texture.downloadAll<std::uint16_t>()) {
        ASSERT_EQ(value, 7);
    }
}

// Of a coarser grid: what is between its voxels, and nothing where all around is nobody's.
TEST_F(SculptureTest, LimitsBetweenVoxelsAreInterpolated) {
    const glm::ivec3 dims(12, 9, 7);
    std::vector<std::byte> texels;
    forEachVoxel({glm::ivec3(0), dims}, [&](glm::ivec3 v, std::size_t) {
        texels.push_back(std::byte(v.x < 5 ? 0 : 30 * (v.x - 5)));
    });
    gl::Texture memberships(dims, gl::Format::R8, gl::Filter::Nearest, "memberships");
    memberships.upload({glm::ivec3(0), dims}, texels);
    field::BrickGrid finest{2 * dims, 32};
    finest.perSceneVoxel = glm::dvec3(2);
    finest.origin = glm::dvec3(0.5);
    Limits limits;
    limits.finest = betweenVoxels(memberships, finest);
    const Box3 empty{{0, 0, 0}, {7, 18, 14}};
    EXPECT_TRUE(mostEnergiesAtFinest(limits, empty).empty());
    EXPECT_EQ(allowedAtFinest(limits, empty), Allowed::All);
    const Box3 box{{6, 3, 2}, {23, 9, 11}};
    EXPECT_EQ(allowedAtFinest(limits, box), Allowed::Some);
    const auto most = mostEnergiesAtFinest(limits, box);
    ASSERT_EQ(most.size(), box.volume());
    forEachVoxel(box, [&](glm::ivec3 v, std::size_t n) {
        const double x = std::clamp((v.x - 0.5) / 2, 5.0, 11.0);
        EXPECT_NEAR(most[n], 1 - 30 * (x - 5) / 255, 0.51 / 255) << v.x;
    });
    limits.takesOnly = true;
    EXPECT_EQ(allowedAtFinest(limits, empty), Allowed::None);
    EXPECT_EQ(mostEnergiesAtFinest(limits, empty), std::vector<float>(empty.volume(), 0.0F));
}

} // namespace
} // namespace vs::sculpt
