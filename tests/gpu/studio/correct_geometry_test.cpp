// SPDX-License-Identifier: Apache-2.0
// Scans whose file is wrong about where their voxels lie.
#include "gpu/studio/test_labels.h"
#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "render/slices/slice_renderer.h"
#include "studio/json/session.h"

namespace vs::studio {
namespace {

using CorrectGeometryTest = ToolsTest;

volume::Volume with(volume::Volume volume, const volume::GridGeometry& geometry) {
    volume.geometry = geometry;
    return volume;
}

std::vector<CorrectGeometry> corrections() {
    return {{.orientation = "RAS"},
            {.orientation = "RPS"}, // a mirror image
            {.orientation = "SLA"},
            {.spacing = glm::dvec3(1, 1, 3)},
            {.spacing = glm::dvec3(0.02, 0.01, 0.01), .orientation = "PIR"}};
}

std::vector<std::vector<unsigned char>> picturesOf(Document& document) {
    std::vector<std::vector<unsigned char>> pictures;
    const View before = document.view();
    for (const auto mode : {render::Mode::Surface, render::Mode::Mip, render::Mode::XRay,
                            render::Mode::Segment, render::Mode::Overlay, render::Mode::Volume}) {
        View view = before;
        view.mode = mode;
        view.shadows = true;
        view.surfaceSmoothing = mode == render::Mode::Surface ? 1 : 0;
        document.showView(view);
        render::RayCaster caster;
        caster.render(document.frame({160, 130}));
        pictures.push_back(caster.readPicture().rgba);
    }
    document.showView(before);
    return pictures;
}

// What a person might do, here and there.
void work(Document& document) {
    document.apply(peelAt(200, 110, 30));
    document.apply(penAt<Drill>(215, 150, 14));
    document.apply(penAt<Laser>(180, 150, 12));
    document.apply(scissorsAt(230, 120, 12));
    test::grownBrain(document, 12);
    document.apply(test::editOf(EditSegment::Kind::Margin, 1.5 * document.volume().geometry.stepMm()));
    Clip clip;
    clip.planes = {{document.volume().geometry.centreWorld(), {0.3, 0.1, 1}}};
    document.apply(clip);
}

TEST_F(CorrectGeometryTest, AScanIsThenAsIfItsFileHadSaidSo) {
    for (const CorrectGeometry& correction : corrections()) {
        Document document(testHead());
        const auto geometry = correction.corrected(document.geometryInFile());
        document.showView(testCanvas().view);
        picturesOf(document); // all is made for where it lay
        document.apply(correction);
        Document right(with(testHead(), geometry));
        right.showView(testCanvas().view);
        EXPECT_TRUE(picturesOf(document) == picturesOf(right));
        work(document);
        work(right);
        EXPECT_TRUE(test::stateOf(document) == test::stateOf(right));
        EXPECT_TRUE(picturesOf(document) == picturesOf(right));
        EXPECT_EQ(document.facts()->growth.millilitres, right.facts()->growth.millilitres);
        EXPECT_EQ(document.geometryInFile(), testHead().geometry);
    }
}

TEST_F(CorrectGeometryTest, WhatWasDoneBeforeStaysInItsVoxels) {
    for (const CorrectGeometry& correction : corrections()) {
        Document document(testHead());
        document.showView(testCanvas().view);
        work(document);
        UseSegment spare{"Segment 1"};
        spare.treatment = SegmentInfo::Treatment::Spare;
        document.apply(spare);
        const auto state = test::stateOf(document);
        const auto pictures = picturesOf(document);
        const double millilitres = document.facts()->growth.millilitres;
        const double mm3 = document.volume().geometry.voxelMm3();
        document.apply(correction);
        EXPECT_TRUE(test::stateOf(document) == state);
        EXPECT_FALSE(picturesOf(document) == pictures);
        const double larger = document.volume().geometry.voxelMm3() / mm3;
        EXPECT_NEAR(document.facts()->growth.millilitres, millilitres * larger, 1e-9 * millilitres * larger);
        document.apply(Note{"corrected"});
        document.apply(Undo{});
        document.apply(Undo{});
        EXPECT_EQ(document.volume().geometry, testHead().geometry);
        EXPECT_TRUE(picturesOf(document) == pictures) << "undo brings the very picture back";
        document.apply(Redo{});
        EXPECT_EQ(document.volume().geometry, correction.corrected(testHead().geometry));
        document.apply(CorrectGeometry{});
        EXPECT_EQ(document.volume().geometry, testHead().geometry) << "as in the file";
    }
}

TEST_F(CorrectGeometryTest, SlicesFollow) {
    Document document(testHead());
    document.apply(CorrectGeometry{.orientation = "SLA"});
    Document right(with(testHead(), document.volume().geometry));
    for (const auto kind : render::kSliceKinds) {
        const auto seen = [&](Document& of) {
            const render::SliceGeometry slice(of.volume().geometry, kind);
            render::SliceRenderer renderer;
            render::SliceView view;
            view.kind = kind;
            view.size = {120, 120};
            view.index = slice.count() / 2;
            renderer.render(of.slice(view));
            return renderer.readPicture().rgba;
        };
        EXPECT_TRUE(seen(document) == seen(right));
    }
}

TEST_F(CorrectGeometryTest, LabelsOfEitherGridAreLoaded) {
    const test::LabelFile labels; // on the head's grid
    Document document(testHead());
    document.apply(CorrectGeometry{.orientation = "RAS"});
    LoadLabels load;
    load.path = labels.path();
    EXPECT_GT(document.apply(load).voxelsTouched, 0U);
    LoadLabels onCorrected;
    auto map = std::make_shared<volume::LabelMap>(*std::get<LoadLabels>(document.log().back()).map);
    map->geometry = document.volume().geometry;
    onCorrected.map = map;
    document.apply(ReSeed{});
    EXPECT_GT(document.apply(onCorrected).voxelsTouched, 0U);
    map->geometry.worldFromVoxel[3].x += 50;
    EXPECT_THROW(document.apply(onCorrected), Error);
}

TEST_F(CorrectGeometryTest, WhatMakesNoSenseIsRefused) {
    Document document(testHead());
    EXPECT_NE(test::refusal(document, CorrectGeometry{.orientation = "LLS"}).find("'LLS'"),
              std::string::npos);
    EXPECT_NE(test::refusal(document, CorrectGeometry{.spacing = glm::dvec3(1, 0, 1)}).find("above 0"),
              std::string::npos);
    EXPECT_EQ(document.volume().geometry, testHead().geometry);
    EXPECT_FALSE(document.history().canUndo());
    document.apply(CorrectGeometry{.orientation = "LPS"});
    EXPECT_FALSE(document.history().canUndo()) << "it says so already";
}

} // namespace
} // namespace vs::studio
