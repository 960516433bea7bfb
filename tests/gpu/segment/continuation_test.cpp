// SPDX-License-Identifier: Apache-2.0
// What segments are taken to be behind cut faces, for pictures.
#include "field/cell_ranges.h"
#include "gpu/gl_test.h"
#include "gpu/segment/growth_cases.h"
#include "segment/growth/growth_undo.h"
#include "segment/membership/segmentation.h"

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

using ContinuationTest = test::GlTest;
constexpr glm::ivec3 kFencedDims{70, 50, 45};

// A sculpture of its own, as the renderer's: cut away where `distance` (voxels) is positive.
struct Sculpted {
    explicit Sculpted(glm::ivec3 dims)
        : texels(dims, gl::Format::R32F, gl::Filter::Linear, "sculpture"),
          cells(field::cellDims(dims), gl::Format::RG32F, gl::Filter::Nearest, "sculpture cells") {}

    template <typename Distance>
    void cut(const Distance& distance) {
        const glm::ivec3 dims = texels.size();
        std::vector<float> values;
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x) {
                    const double d = distance(glm::dvec3(x, y, z));
                    values.push_back(float(0.5 + 0.5 * std::erf(d / std::sqrt(2.0))));
                }
            }
        }
        texels.upload({glm::ivec3(0), dims}, std::as_bytes(std::span(values)));
        field::CellRangeUpdater().update(texels, {glm::ivec3(0), dims}, cells);
        ++version;
    }
    // `changed`: what differs from the last version.
    [[nodiscard]] Fence fence(field::SculptureView view, Box3 changed = {glm::ivec3(0), kFencedDims}) const {
        return {&texels, &cells, view, version, [changed](std::uint64_t) { return changed; }};
    }
    void fenceIn(Constraints& constraints, field::SculptureView view) const {
        constraints.sculpture = &texels;
        constraints.sculptureVersion = version;
        constraints.view = view;
    }

    gl::Texture texels;
    gl::Texture cells;
    std::uint64_t version = 0;
};

double belowPlane(glm::dvec3 p) {
    return glm::dot(p - glm::dvec3(35, 25, 22), glm::normalize(glm::dvec3(2, 1, 1)));
}

// Whatever has happened, an update makes what a segmentation that is new makes at once.
TEST_F(ContinuationTest, IncrementalUpdatesEqualFreshOnesByteForByte) {
    const auto volume = randomVolume(kFencedDims, volume::ScalarType::UInt8, 0, 100);
    const field::Field field = field::uploadVolume(volume);
    Growth growth(field);
    Sculpted sculpted(kFencedDims);
    sculpted.cut(belowPlane);
    Segmentation segmentation(volume.geometry);
    field::SculptureView view = field::SculptureView::Cut;
    Box3 box{glm::ivec3(0), kFencedDims};
    Looks looks = allOpaque();
    std::size_t counted = 0; // texels that a fence changes
    const auto check = [&](const std::string& what) {
        segmentation.update(growth, Smoothing::Smooth, looks, Segmentation::kNoHurry,
                            sculpted.fence(view, box));
        Segmentation fresh(volume.geometry);
        fresh.update(growth, Smoothing::Smooth, looks, Segmentation::kNoHurry, sculpted.fence(view));
        const auto texels = texelsOf(segmentation);
        EXPECT_TRUE(texels == texelsOf(fresh)) << what;
        Segmentation plain(volume.geometry);
        plain.update(growth, Smoothing::Smooth, looks);
        const auto without = texelsOf(plain);
        counted = 0;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            counted += texels[i] != without[i] ? 1 : 0;
        }
    };
    Constraints constraints;
    constraints.range = {0, 60};
    sculpted.fenceIn(constraints, view);
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{15, 15, 15}, {16, 16, 16}, {30, 20, 15}});
    check("seeds");
    growth.advance(9);
    check("on the way");
    growth.advance(kAll);
    check("grown");
    EXPECT_GT(counted, 5000U) << "the plane cuts through all of it";
    growth.setPlayhead(8);
    check("back");
    growth.setPlayhead(kAll);
    // Only a corner of the cut is put back.
    const auto dented = [](glm::dvec3 p) {
        return std::min(belowPlane(p), glm::length(p - glm::dvec3(40, 25, 22)) - 8.0);
    };
    sculpted.cut(dented);
    box = {{28, 13, 10}, {53, 38, 35}};
    check("a part put back");
    GrowthUndo undo;
    constraints.range = {0, 70};
    sculpted.fenceIn(constraints, view);
    growth.setConstraints(constraints, &undo);
    check("other rules");
    growth.advance(kAll);
    check("grown under them");
    growth.activate(2);
    constraints.range = {61, 100};
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{12, 30, 20}});
    growth.advance(30);
    check("another segment");
    looks[1] = Look::Hidden;
    check("one of them hidden");
    looks[1] = Look::Translucent;
    check("one of them of glass");
    looks[1] = Look::Opaque;
    growth.reset();
    check("one of them erased");
    view = field::SculptureView::Probe;
    box = {glm::ivec3(0), kFencedDims};
    check("seen from the other side");
    view = field::SculptureView::Whole;
    check("whole");
    EXPECT_EQ(counted, 0U) << "nothing is behind anything";
}

// A voxel on its own next to the cut face is seen there as it would be in the middle of the grid.
TEST_F(ContinuationTest, WhatIsThinGoesOnToo) {
    const auto volume = phantom::makePhantom({24, 24, 24}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        return p.x == 12 && p.y == 12 ? 100.0 : 10.0; // a wire
    });
    const field::Field field = field::uploadVolume(volume);
    Sculpted sculpted(volume.geometry.dims);
    sculpted.cut([](glm::dvec3 p) { return p.z - 12.3; });
    Growth growth(field);
    Constraints constraints;
    constraints.range = {50, 150};
    sculpted.fenceIn(constraints, field::SculptureView::Cut);
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{12, 12, 4}});
    growth.advance(kAll);
    EXPECT_EQ(growth.voxelCount(), 13U);
    Segmentation segmentation(volume.geometry);
    segmentation.update(growth, Smoothing::Smooth, allOpaque(), Segmentation::kNoHurry,
                        {&sculpted.texels, &sculpted.cells, field::SculptureView::Cut, 1});
    const auto texels = texelsOf(segmentation);
    const auto at = [&](int x, int y, int z) { return int(texels[(std::size_t(z) * 24 + y) * 24 + x]); };
    for (const int z : {11, 12, 13}) {
        EXPECT_NEAR(at(12, 12, z), at(12, 12, 8), 1) << z;
        EXPECT_NEAR(at(13, 12, z), at(13, 12, 8), 1) << z;
    }
    EXPECT_LT(at(12, 12, 17), 128) << "but not far";
}

// What an edit or a label map has given is known behind the face: where it goes on by itself, nothing is
// added.
TEST_F(ContinuationTest, WhatIsKnownBehindTheFaceIsLeftAlone) {
    const auto volume =
        phantom::makePhantom({40, 40, 40}, volume::ScalarType::UInt8, [](glm::dvec3) { return 100.0; });
    const field::Field field = field::uploadVolume(volume);
    Sculpted sculpted(volume.geometry.dims);
    sculpted.cut([](glm::dvec3 p) { return p.z - 20.4; });
    Growth growth(field);
    Constraints constraints;
    constraints.range = {50, 150};
    sculpted.fenceIn(constraints, field::SculptureView::Cut);
    growth.setConstraints(constraints);
    std::vector<std::uint8_t> ball;
    for (int i = 0; i < 64000; ++i) {
        const glm::dvec3 p(i % 40, i / 40 % 40, i / 1600);
        ball.push_back(glm::length(p - glm::dvec3(20, 20, 16)) < 12 ? 1 : 0);
    }
    growth.replace(volume.geometry.box(), ball);
    const Fence fence{&sculpted.texels, &sculpted.cells, field::SculptureView::Cut, 1};
    Segmentation with(volume.geometry);
    with.update(growth, Smoothing::Smooth, allOpaque(), Segmentation::kNoHurry, fence);
    Segmentation without(volume.geometry);
    without.update(growth);
    EXPECT_TRUE(texelsOf(with) == texelsOf(without));
    // Cut off at the face, it goes on straight: nobody knows how else.
    for (std::size_t i = std::size_t(21) * 1600; i < ball.size(); ++i) {
        ball[i] = 0;
    }
    growth.replace(volume.geometry.box(), ball);
    with.update(growth, Smoothing::Smooth, allOpaque(), Segmentation::kNoHurry, fence);
    const auto texels = texelsOf(with);
    EXPECT_GT(texels[21 * 1600 + 20 * 40 + 20], 250);
    EXPECT_GT(texels[21 * 1600 + 20 * 40 + 29], 127);
    EXPECT_LT(texels[21 * 1600 + 20 * 40 + 33], 127);
}

TEST_F(ContinuationTest, SixBytesAVoxelAreStillEnough) {
    const glm::ivec3 dims(181, 217, 181);
    const auto volume =
        phantom::makePhantom(dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 10.0; });
    const field::Field field = field::uploadVolume(volume);
    Sculpted sculpted(dims);
    sculpted.cut([](glm::dvec3 p) { return p.z - 95.2; });
    Growth growth(field);
    Constraints constraints;
    constraints.range = {10, 10};
    sculpted.fenceIn(constraints, field::SculptureView::Cut);
    growth.setConstraints(constraints);
    growth.addSeeds(std::vector<glm::ivec3>{{90, 90, 90}});
    growth.advance(20);
    Segmentation segmentation(volume.geometry);
    segmentation.update(growth, Smoothing::Smooth, allOpaque(), Segmentation::kNoHurry,
                        {&sculpted.texels, &sculpted.cells, field::SculptureView::Cut, 1});
    EXPECT_TRUE(segmentation.goesOnBehindCuts());
    constexpr double kScratchBytes = 13 << 20; // of a size of its own
    const double bytes = double(growth.deviceBytes() + segmentation.deviceBytes()) - kScratchBytes;
    EXPECT_LT(bytes / double(volume.geometry.voxelCount()), 6.0);
}

} // namespace
} // namespace vs::segment
