// SPDX-License-Identifier: Apache-2.0
// What slices show from black to white, whatever range is displayed.
#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "render/slices/slice_renderer.h"
#include "render/slices/slice_windows.h"
#include "studio/document/document.h"
#include "studio/document/document_facts.h"

#include <random>

namespace vs::studio {
namespace {

using SliceWindowTest = test::GlTest;

constexpr glm::dvec3 kMiddle{31.5, 31.5, 23.5};

// A head of an MR scan, in tissues by the distance from the middle: fluid of 45, brain around 130, scalp 230,
// air; with noise, which air has the magnitude of.
volume::Volume noisyHead(double noise, volume::ScalarType type = volume::ScalarType::Int16) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0, noise);
    return phantom::makePhantom({64, 64, 48}, type, [&](glm::dvec3 p) {
        const double r = glm::length(p - kMiddle);
        const double value = r > 23 ? 0 : r > 20 ? 230 : r > 7 ? 130 : 45;
        return std::round(std::abs(value + normal(random)));
    });
}

// Its mean grey between two distances from the middle.
double meanGrey(Document& document, double from, double to) {
    const render::SliceView view{render::SliceKind::Axial, 23, {}, 0.5, {128, 128}};
    render::SliceRenderer renderer;
    renderer.render(document.slice(view));
    const image::Image seen = renderer.readPicture();
    const render::SliceGeometry geometry(document.volume().geometry, view.kind);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const double r =
                glm::length(geometry.voxelAt(view.placeAt({x + 0.5, y + 0.5}), view.index) - kMiddle);
            if (r > from && r < to) {
                sum += seen.pixel(x, y)[1];
                ++count;
            }
        }
    }
    return sum / std::max(count, 1);
}

image::Image sliceOf(Document& document) {
    render::SliceRenderer renderer;
    renderer.render(document.slice({render::SliceKind::Coronal, 30, {}, 0.5, {120, 120}}));
    return renderer.readPicture();
}

TEST_F(SliceWindowTest, FluidIsToldFromAirAndFromBrainOnCleanAndNoisyScans) {
    for (const double noise : {0.0, 4.0, 12.0}) {
        Document document(noisyHead(noise));
        EXPECT_GT(document.view().range.lo, 45) << "the displayed range hides the fluid, which this is about";
        const double air = meanGrey(document, 25, 30);
        const double fluid = meanGrey(document, 0, 6);
        const double brain = meanGrey(document, 9, 18);
        EXPECT_LT(air, 25) << noise;
        EXPECT_GT(fluid, air + 20) << noise;
        EXPECT_GT(brain, fluid + 60) << noise;
        EXPECT_LT(brain, 200) << noise << ": scalp is brighter still";
    }
}

TEST_F(SliceWindowTest, TheDisplayedRangeChangesNoSlice) {
    Document document(noisyHead(5));
    const auto before = sliceOf(document);
    View view = document.view();
    view.range = {100, 140};
    document.showView(view);
    EXPECT_EQ(sliceOf(document).rgba, before.rgba);
    view.tintsSlices = true;
    document.showView(view);
    EXPECT_NE(sliceOf(document).rgba, before.rgba);
}

TEST_F(SliceWindowTest, HounsfieldUnitsAreSeenAsSoftTissue) {
    auto scan = noisyHead(20);
    scan.unit = "HU";
    EXPECT_NE(Document(noisyHead(20)).facts()->sliceWindow, render::kAbdomenWindow);
    auto wide = phantom::makePhantom({32, 32, 32}, volume::ScalarType::Int16, [](glm::dvec3 p) {
        return p.x < 10 ? -1000 : p.x < 20 ? 40 : 1500;
    });
    wide.unit = "HU";
    EXPECT_EQ(Document(wide).facts()->sliceWindow, render::kAbdomenWindow);
    // A part of a scan that has no such values is seen as it is.
    EXPECT_NE(Document(scan).facts()->sliceWindow, render::kAbdomenWindow);
}

TEST_F(SliceWindowTest, ScansOfOneOrTwoValuesHaveAWindow) {
    const auto even =
        phantom::makePhantom({8, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3) { return 7; });
    EXPECT_TRUE(Document(even).facts()->sliceWindow.contains(7));
    EXPECT_GT(Document(even).facts()->sliceWindow.width(), 0);
    const auto mask = phantom::makePhantom({8, 8, 8}, volume::ScalarType::UInt8, [](glm::dvec3 p) {
        return p.x < 1 && p.y < 1 && p.z < 1 ? 1 : 0;
    });
    EXPECT_GT(Document(mask).facts()->sliceWindow.width(), 0);
}

TEST_F(SliceWindowTest, OnlySlicesAreNewForAnotherWindow) {
    Document document(noisyHead(0));
    const auto slices = document.version();
    const auto picture = document.pictureVersion();
    View view = document.view();
    view.sliceWindow = Range{10, 60};
    document.showView(view);
    EXPECT_GT(document.version(), slices);
    EXPECT_EQ(document.pictureVersion(), picture);
    SetView back;
    back.sliceWindow.emplace(std::nullopt);
    document.apply(back);
    EXPECT_EQ(document.view().sliceWindow, std::nullopt);
    EXPECT_EQ(document.pictureVersion(), picture);
    view.range.lo += 1;
    document.showView(view);
    EXPECT_GT(document.pictureVersion(), picture);
}

TEST_F(SliceWindowTest, TheWindowIsShownFromBlackToWhite) {
    Document document(noisyHead(0));
    View view = document.view();
    view.sliceWindow = Range{45, 130}; // fluid to brain
    document.showView(view);
    EXPECT_LT(meanGrey(document, 0, 6), 1);
    EXPECT_GT(meanGrey(document, 9, 18), 254);
}

} // namespace
} // namespace vs::studio
