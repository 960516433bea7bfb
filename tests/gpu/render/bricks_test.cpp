// SPDX-License-Identifier: Apache-2.0
// Pictures from bricks beside those of the same volume in one texture, whatever the bricks' size, the room
// for them and the order in which they come; and what is seen of a level that is finer than the scene's.
#include "base/error.h"
#include "field/bricks/detail.h"
#include "field/finer_cells.h"
#include "gpu/field/two_levels.h"
#include "gpu/gl_test.h"
#include "gpu/render/segment_stage.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "property.h"
#include "render/colours/function_edits.h"
#include "render/slices/slice_renderer.h"
#include "volume/grid/reduced.h"

#include <glm/gtc/matrix_transform.hpp>

#include <chrono>
#include <random>
#include <thread>

namespace vs::render {
namespace {

using BricksTest = test::GlTest;
using test::Stage;
using test::TwoLevels;

// A few soft balls of any brightness: smooth, so that a hair in where a sample lies is a hair in what is
// seen.
volume::Volume drawVolume(int seed, volume::ScalarType type) {
    std::mt19937 random{std::mt19937::result_type(seed)};
    const auto upTo = [&](int n) { return double(random() % unsigned(n)); };
    const glm::ivec3 dims = 2 * glm::ivec3(10 + int(upTo(25)), 10 + int(upTo(25)), 10 + int(upTo(25)));
    struct Ball {
        glm::dvec3 centre;
        double radius;
        double value;
    };
    std::vector<Ball> balls(5);
    for (Ball& ball : balls) {
        ball = {glm::dvec3(upTo(dims.x), upTo(dims.y), upTo(dims.z)), 6 + upTo(12), 40 + upTo(80)};
    }
    auto volume = phantom::makePhantom(
        dims, type,
        [&](glm::dvec3 p) {
            double value = 0;
            for (const Ball& ball : balls) {
                value += ball.value / (1 + std::exp((glm::distance(p, ball.centre) - ball.radius) / 2));
            }
            return std::min(value, 127.0);
        },
        {1 + upTo(10) / 10, 1, 1 + upTo(10) / 10});
    volume.geometry.worldFromVoxel =
        glm::rotate(glm::dmat4(1), upTo(60) / 10, glm::dvec3(1, 2, 3)) * volume.geometry.worldFromVoxel;
    return volume;
}

// Reads late, each box by another time.
class LateBricks : public volume::VolumeBricks {
public:
    LateBricks(const volume::Volume& volume, int seed) : VolumeBricks(volume, volume.geometry), seed_(seed) {}
    [[nodiscard]] std::vector<std::byte> read(int level, const Box3& box) const override {
        const unsigned hash = unsigned(seed_ + box.lo.x * 7 + box.lo.y * 131 + box.lo.z * 1031) * 2654435761U;
        std::this_thread::sleep_for(std::chrono::microseconds(hash >> 22));
        return VolumeBricks::read(level, box);
    }

private:
    int seed_;
};

std::size_t bytesFor(int bricks, int side, volume::ScalarType type) {
    return std::size_t(bricks) * std::size_t(side + 1) * std::size_t(side + 1) * std::size_t(side + 1) *
           gl::bytesPerTexel(field::brickTexels(type).format);
}

// As many bricks as the rays of a few pixels may meet: they are some 20 voxels apart at the most.
int fewestBricks(glm::ivec3 dims, int side) {
    const glm::ivec3 counts = divideUp(dims, side);
    const int across = 2 + 20 / side;
    return across * across * (counts.x + counts.y + counts.z);
}

TEST_F(BricksTest, PicturesAreThoseOfOneTexture) {
    test::checkProperty(24, [] {
        const auto type = volume::kScalarTypes[std::size_t(*test::below(int(volume::kScalarTypes.size())))];
        const int seed = *test::below(10000);
        Stage stage(drawVolume(seed, type), {30, 200});
        const int side = 5 + *test::below(40);
        const bool isCut = *test::coin();
        const Mode mode = Mode(std::array{0, 1, 2, 5}[std::size_t(*test::below(4))]);
        stage.frame.scene.sampling =
            *test::below(4) == 0 ? field::Sampling::Tricubic : field::Sampling::Trilinear;
        stage.frame.samples = 1 + *test::below(5);
        stage.frame.endsEarly = *test::coin();
        stage.frame.background = backgroundFromName(*test::coin() ? "white" : "studio");
        Camera camera{double(*test::below(360)), double(*test::below(90)), 0.7 + 0.1 * *test::below(20)};
        camera.projection = *test::coin() ? Projection::Orthographic : Projection::Perspective;
        stage.look(camera, {120, 90});
        if (isCut) {
            stage.cutAbove(stage.volume.geometry.dims.x / 2.0);
        }
        if (mode == Mode::Volume) {
            stage.classify(functionOfRange({30, 200}));
        }
        const auto whole = stage.picture(mode);

        field::DetailOptions options;
        options.side = side;
        options.hasOwnLevel = true;
        options.threads = 1 + *test::below(4);
        const int fewest = fewestBricks(stage.volume.geometry.dims, side);
        options.deviceBytes = bytesFor(fewest + *test::below(60), side, type);
        options.hostBytes = bytesFor(1 + *test::below(100), side, type);
        options.areRangesKnown = *test::below(3) == 0; // then only macrocells say what can be passed
        field::Detail detail(std::make_shared<LateBricks>(stage.volume, seed), stage.volume.geometry,
                             options);
        stage.frame.detail = &detail;
        if (!options.areRangesKnown) { // rays find by bricks alone where nothing is
            stage.cells = field::finerCellRanges(stage.volume.geometry.dims, detail.grids().front(), {});
        }
        const auto inBricks = stage.picture(mode);
        stage.frame.detail = nullptr;
        const auto difference = image::compare(whole, inBricks);
        RC_ASSERT(detail.bricksRead() > 0U);
        RC_ASSERT(detail.failures().empty());
        RC_ASSERT(difference.mean < 0.02);
        // A ray that grazes a surface may meet it or not, by rounding.
        RC_ASSERT(difference.changedFraction < 5e-4);
    });
}

// What is all alike begins at a sample that hangs on rounding, and its tint on where it begins. (Where a ray
// meets the like twice, and once by a hair, it is not known which is the brightest.)
TEST_F(BricksTest, TheBrightestIsTintedAlike) {
    test::SegmentStage stage([](glm::dvec3 p) {
        const double r = glm::length(p - test::kCentre);
        return r < 9 ? 180.0 : r < 14 ? 240.0 : 130.0;
    });
    stage.nest({0.9F, 0.1F, 0.1F, 0.7F}, {0.1F, 0.8F, 0.2F, 1.0F});
    stage.frame.samples = 2;
    for (int n = 0; n < 12; ++n) {
        stage.look({31.0 * n,
                    7.0 * n - 30,
                    1.3,
                    {},
                    n % 2 == 0 ? Projection::Orthographic : Projection::Perspective},
                   {160, 120});
        const auto whole = stage.picture(Mode::Mip);
        field::DetailOptions options;
        options.side = 7 + 5 * (n % 5);
        options.hasOwnLevel = true;
        options.deviceBytes = bytesFor(400, options.side, volume::ScalarType::UInt8);
        options.hostBytes = std::size_t(1) << 24;
        field::Detail detail(std::make_shared<volume::VolumeBricks>(stage.volume, stage.volume.geometry),
                             stage.volume.geometry, options);
        stage.frame.detail = &detail;
        const auto inBricks = stage.picture(Mode::Mip);
        stage.frame.detail = nullptr;
        EXPECT_GT(detail.bricksRead(), 0U) << n;
        EXPECT_LE(image::compare(whole, inBricks).max, 1) << n;
    }
}

TEST_F(BricksTest, SlicesAreThoseOfOneTexture) {
    const Stage stage(drawVolume(3, volume::ScalarType::Int16), {0, 127});
    field::DetailOptions options;
    options.side = 16;
    options.hasOwnLevel = true;
    field::Detail detail(std::make_shared<LateBricks>(stage.volume, 3), stage.volume.geometry, options);
    SliceRenderer renderer;
    for (const SliceKind kind : kSliceKinds) {
        for (const bool isSmooth : {true, false}) {
            SliceFrame frame;
            frame.scene = stage.frame.scene;
            frame.window = {0, 127};
            frame.isSmooth = isSmooth;
            frame.view = {kind, 9, {0.4, 1.1}, 0.31, {90, 70}};
            renderer.render(frame);
            const auto whole = renderer.readPicture();
            frame.detail = &detail;
            renderer.render(frame);
            EXPECT_FALSE(renderer.missesBricks());
            EXPECT_LE(image::compare(whole, renderer.readPicture()).max, 1) << int(kind) << isSmooth;
        }
    }
}

TEST_F(BricksTest, APictureOfAFinerLevelIsThatOfItsVolume) {
    for (const int seed : {1, 5}) {
        const auto fine = drawVolume(seed, volume::ScalarType::UInt16);
        Camera camera{25, 15, 1.4};
        const glm::ivec2 size{200, 150};
        Stage whole(fine, {30, 127});
        whole.look(camera, size);
        const auto source = std::make_shared<TwoLevels>(fine);
        Stage coarse(source->coarse(), {30, 127});
        coarse.look(camera, size);
        field::DetailOptions options;
        options.side = 16;
        field::Detail detail(source, coarse.volume.geometry, options);
        coarse.cells = field::finerCellRanges(coarse.volume.geometry.dims, detail.grids().front(), {});
        for (const Mode mode : {Mode::Surface, Mode::Mip}) {
            const auto wanted = whole.picture(mode);
            coarse.frame.detail = nullptr;
            const double before = image::compare(wanted, coarse.picture(mode)).mean;
            coarse.frame.detail = &detail;
            const auto difference = image::compare(wanted, coarse.picture(mode));
            EXPECT_EQ(detail.level(), 0);
            EXPECT_LT(difference.mean, 0.1 * before) << name(mode) << ' ' << seed;
            EXPECT_LT(difference.changedFraction, 0.01) << name(mode) << ' ' << seed;
        }
    }
}

TEST_F(BricksTest, TheLevelIsTheOneThatPixelsAskFor) {
    auto fine = drawVolume(2, volume::ScalarType::UInt8);
    fine.geometry = volume::makeGeometry(fine.geometry.dims);
    const auto source = std::make_shared<TwoLevels>(fine);
    const auto scene = volume::reduced(fine, glm::ivec3(4), volume::Reducing::Mean);
    field::Detail detail(source, scene.geometry, {});
    EXPECT_EQ(detail.levelFor(1.5), std::nullopt); // the scene's own voxels are small enough
    EXPECT_EQ(detail.levelFor(0.9), 1);
    EXPECT_EQ(detail.levelFor(0.51), 1);
    EXPECT_EQ(detail.levelFor(0.49), 0);
    EXPECT_EQ(detail.levelFor(0.01), 0);
    EXPECT_THROW(field::Detail(source, fine.geometry, {}), Error); // none is finer than the finest
}

// Microscopes' stacks have thick slices, which coarser levels keep.
TEST_F(BricksTest, AxesThatBecomeNoFinerAskForNothing) {
    auto fine = drawVolume(2, volume::ScalarType::UInt8);
    for (const double thickness : {0.3, 1.0, 4.0}) {
        fine.geometry = volume::makeGeometry(fine.geometry.dims, {0.3, 0.3, thickness});
        const auto source = std::make_shared<TwoLevels>(fine, glm::ivec3(2, 2, 1));
        const auto scene = volume::reduced(fine, {4, 4, 1}, volume::Reducing::Mean);
        const field::Detail detail(source, scene.geometry, {});
        ASSERT_EQ(detail.grids().size(), 2U);
        const double step = scene.geometry.stepMm();
        EXPECT_EQ(detail.levelFor(1.25 / step), std::nullopt) << thickness; // mm
        EXPECT_EQ(detail.levelFor(0.61 / step), 1) << thickness;
        EXPECT_EQ(detail.levelFor(0.55 / step), 0) << thickness;
        EXPECT_TRUE(detail.isFiner());
    }
}

// A store that says nothing of what its levels hold: each brick is read once, and then it is known where
// nothing can be seen, though there is no room to keep them.
TEST_F(BricksTest, WhatHoldsNothingThatIsSeenIsReadOnce) {
    const glm::ivec3 dims(96);
    const auto fine = phantom::makePhantom(dims, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        return glm::distance(p, glm::dvec3(20, 24, 28)) < 14 ? 120.0 : 20.0;
    });
    const auto source = std::make_shared<TwoLevels>(fine);
    Stage stage(source->coarse(), {60, 127});
    field::DetailOptions options;
    options.side = 8;
    const int bricks = 12 * 12 * 12;
    options.deviceBytes = bytesFor(bricks / 4, options.side, volume::ScalarType::UInt8);
    options.hostBytes = 1;
    field::Detail detail(source, stage.volume.geometry, options);
    ASSERT_TRUE(detail.hasTellingRanges(field::kCell));
    stage.cells = field::finerCellRanges(stage.volume.geometry.dims, detail.grids().front(), {});
    stage.frame.detail = &detail;
    for (const double azimuth : {20.0, 110.0, 200.0, 290.0, 20.0}) {
        stage.look({azimuth, 15, 1.4}, {160, 120});
        stage.picture(Mode::Surface);
    }
    EXPECT_TRUE(detail.failures().empty());
    const int seen = 6 * 6 * 6; // bricks about the ball, which are read again when they had to make room
    EXPECT_LE(detail.bricksRead(), std::size_t(bricks + 5 * seen));
    const std::size_t before = detail.bricksRead();
    stage.picture(Mode::Surface);
    EXPECT_EQ(detail.bricksRead(), before);
}

// Memory is taken when it is needed, and bricks come again that had to go meanwhile, with what lies over
// them.
TEST_F(BricksTest, ThePoolGrowsWithWhatIsLookedAt) {
    Stage stage(drawVolume(7, volume::ScalarType::UInt8), {30, 127});
    const auto dims = stage.volume.geometry.dims;
    field::DetailOptions options;
    options.side = 6;
    options.hasOwnLevel = true;
    const glm::ivec3 counts = divideUp(dims, options.side);
    const int all = counts.x * counts.y * counts.z;
    ASSERT_GT(all, 300);
    options.deviceBytes = bytesFor(all, options.side, volume::ScalarType::UInt8) + 7;
    field::Detail detail(std::make_shared<LateBricks>(stage.volume, 7), stage.volume.geometry, options);
    const std::size_t first = detail.deviceBytes();
    stage.cells = field::finerCellRanges(dims, detail.grids().front(), {});
    stage.look({25, 15, 1.2}, {160, 120});
    const auto whole = stage.picture(Mode::XRay);
    stage.frame.detail = &detail;
    const auto inBricks = stage.picture(Mode::XRay);
    EXPECT_LE(image::compare(whole, inBricks).max, 1);
    EXPECT_GT(detail.deviceBytes(), 2 * first);
    EXPECT_GT(detail.bricksRead(), 256U); // it grew twice
    EXPECT_LE(image::compare(whole, stage.picture(Mode::XRay)).max, 1);
    const std::size_t before = detail.bricksRead();
    stage.picture(Mode::XRay);
    EXPECT_EQ(detail.bricksRead(), before);
}

TEST_F(BricksTest, WhatCannotBeReadIsToldAndShownCoarser) {
    const auto fine = drawVolume(1, volume::ScalarType::UInt8);
    const auto source = std::make_shared<TwoLevels>(fine);
    source->unreadable = glm::ivec3(0);
    Stage stage(source->coarse(), {5, 127});
    stage.look({25, 15, 1.4}, {200, 150});
    field::DetailOptions options;
    options.side = 64; // one brick, or a few
    field::Detail detail(source, stage.volume.geometry, options);
    stage.cells = field::finerCellRanges(stage.volume.geometry.dims, detail.grids().front(), {});
    stage.frame.detail = &detail;
    const auto picture = stage.picture(Mode::Mip);
    ASSERT_EQ(detail.failures().size(), 1U);
    EXPECT_EQ(detail.failures().front(), "chunk 0.0.0: it is damaged; pictures are coarser there");
    stage.frame.detail = nullptr;
    EXPECT_LT(image::compare(picture, stage.picture(Mode::Mip)).mean, 4); // there all the same
    EXPECT_TRUE(stage.caster.isComplete());
}

TEST_F(BricksTest, RoomForTooFewBricksIsSaidAndThePictureIsCoarser) {
    Stage stage(drawVolume(4, volume::ScalarType::UInt8), {30, 127});
    field::DetailOptions options;
    options.side = 4;
    options.hasOwnLevel = true;
    options.deviceBytes = bytesFor(2, 4, volume::ScalarType::UInt8);
    field::Detail detail(std::make_shared<LateBricks>(stage.volume, 1), stage.volume.geometry, options);
    stage.frame.detail = &detail;
    const auto inBricks = stage.picture(Mode::XRay);
    ASSERT_EQ(detail.failures().size(), 1U);
    EXPECT_NE(detail.failures().front().find("--device-memory"), std::string::npos);
    stage.frame.detail = nullptr;
    EXPECT_EQ(image::compare(inBricks, stage.picture(Mode::XRay)).max, 0);
}

// What the extremes say must hold for every sample of any level.
TEST_F(BricksTest, FinerCellsHoldWhatSamplesFind) {
    test::checkProperty(30, [] {
        const auto fine = drawVolume(*test::below(1000), volume::ScalarType::UInt8);
        const int by = 1 << (1 + *test::below(2));
        const auto scene = volume::reduced(fine, glm::ivec3(by), volume::Reducing::Mean);
        const auto middle = volume::reduced(fine, glm::ivec3(by / 2), volume::Reducing::Mean);
        const auto grid = field::brickGrid(fine.geometry, scene.geometry, 16);
        const auto ofMiddle = field::brickGrid(middle.geometry, scene.geometry, 16);
        RC_ASSERT(grid && ofMiddle);
        volume::CellExtremes extremes{4 << *test::below(2), {}, volume::ScalarType::UInt8, {}};
        extremes.cells = divideUp(fine.geometry.dims, extremes.side);
        forEachVoxel({glm::ivec3(0), extremes.cells}, [&](glm::ivec3 cell, std::size_t) {
            std::uint8_t lo = 255;
            std::uint8_t hi = 0;
            const Box3 box =
                intersect({cell * extremes.side, (cell + 1) * extremes.side}, fine.geometry.box());
            forEachVoxel(box, [&](glm::ivec3 v, std::size_t) {
                const auto value = std::uint8_t(fine.at(v));
                lo = std::min(lo, value);
                hi = std::max(hi, value);
            });
            extremes.ranges.push_back(std::byte(lo));
            extremes.ranges.push_back(std::byte(hi));
        });
        const auto cells = field::finerCellRanges(scene.geometry.dims, *grid, extremes);
        const auto ranges = cells.cells.downloadAll<glm::vec2>();
        // The voxels around samples in a cell, of both levels.
        const glm::ivec3 count = cells.cells.size();
        forEachVoxel({glm::ivec3(0), count}, [&](glm::ivec3 cell, std::size_t n) {
            for (const auto& seen : {std::pair(&fine, &*grid), std::pair(&middle, &*ofMiddle)}) {
                const volume::Volume* volume = seen.first;
                const field::BrickGrid* level = seen.second;
                const glm::dvec3 lo = glm::dvec3(cell * field::kCell) * level->perSceneVoxel + level->origin;
                const glm::dvec3 hi =
                    glm::dvec3((cell + 1) * field::kCell) * level->perSceneVoxel + level->origin;
                const Box3 box = intersect({glm::ivec3(glm::floor(lo)), glm::ivec3(glm::ceil(hi)) + 1},
                                           volume->geometry.box());
                forEachVoxel(box, [&](glm::ivec3 v, std::size_t) {
                    const double value = volume->at(v);
                    RC_ASSERT((value >= double(ranges[n].x) && value <= double(ranges[n].y)));
                });
            }
        });
    });
}

} // namespace
} // namespace vs::render
