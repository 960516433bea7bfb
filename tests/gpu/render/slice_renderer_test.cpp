// SPDX-License-Identifier: Apache-2.0
// Slices against a plain CPU picture, and what is special about them: cuts, outlines, looks of segments.
#include "gpu/gl_test.h"
#include "gpu/render/stage.h"
#include "phantom/phantom.h"
#include "reference/slice_renderer.h"
#include "render/slices/slice_renderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cstdlib>
#include <random>

namespace vs::render {
namespace {

using SliceRendererTest = test::GlTest;
using test::Stage;

// Random values, in a grid that is anisotropic, turned and flipped.
volume::Volume noise(volume::ScalarType type = volume::ScalarType::Int16) {
    std::mt19937 random(7);
    auto volume = phantom::makePhantom({23, 17, 12}, type, [&](glm::dvec3) {
        return double(int(random() % 900)) - (type == volume::ScalarType::UInt8 ? 0 : 450);
    });
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.4, glm::dvec3(0.2, -1, 0.5));
    volume.geometry.worldFromVoxel = turn * glm::scale(glm::dmat4(1), glm::dvec3(-0.7, 1.3, 2.1));
    return volume;
}

SliceFrame frameOf(const Stage& stage, const SliceView& view) {
    SliceFrame frame;
    frame.scene = stage.frame.scene;
    frame.segmentColours = stage.frame.segmentColours;
    frame.window = frame.scene.displayedRange;
    frame.view = view;
    frame.outlinePixels = -1; // none
    return frame;
}

image::Image draw(const SliceFrame& frame) {
    static SliceRenderer* const renderer = new SliceRenderer; // outlives every test's context user
    renderer->render(frame);
    return renderer->readPicture();
}

// Odd sizes and zooms, whole and in part.
std::vector<SliceView> views(const volume::GridGeometry& grid) {
    std::vector<SliceView> views;
    for (const SliceKind kind : kSliceKinds) {
        const SliceGeometry geometry(grid, kind);
        const glm::ivec2 size{67, 45};
        const double all = pixelMmToShowAll(geometry, size);
        views.push_back({kind, 0, {0, 0}, all, size});
        views.push_back({kind, geometry.count() / 2, {1.3, -2.1}, 0.37 * all, size});
        views.push_back({kind, geometry.count() - 1, {-4, 3}, 0.11 * all, size});
    }
    return views;
}

int largestDifference(const image::Image& a, const image::Image& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        largest = std::max(largest, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
    }
    return largest;
}

// Pixels that differ by more than so much: where rounding puts a place on the other side of a border.
int pixelsApart(const image::Image& a, const image::Image& b, int by) {
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            bool isApart = false;
            for (int c = 0; c < 4; ++c) {
                isApart = isApart || std::abs(int(a.pixel(x, y)[c]) - int(b.pixel(x, y)[c])) > by;
            }
            count += isApart ? 1 : 0;
        }
    }
    return count;
}

TEST_F(SliceRendererTest, NearestValuesAreTheVoxelsOwn) {
    for (const auto type :
         {volume::ScalarType::UInt8, volume::ScalarType::Int16, volume::ScalarType::Float32}) {
        const Stage stage(noise(type), {-200, 250});
        for (const SliceView& view : views(stage.volume.geometry)) {
            SliceFrame frame = frameOf(stage, view);
            frame.isSmooth = false;
            const auto expected = reference::drawSlice({&stage.volume, {-200, 250}, {}, {}, {}, false}, view);
            // 1: half a grey level is rounded either way.
            EXPECT_LE(pixelsApart(draw(frame), expected, 1), 1) << name(view.kind) << view.index;
        }
    }
}

TEST_F(SliceRendererTest, SmoothValuesAreInterpolatedWithinTheSlice) {
    const Stage stage(noise(), {-200, 250});
    for (const SliceView& view : views(stage.volume.geometry)) {
        const auto expected = reference::drawSlice({&stage.volume, {-200, 250}, {}, {}, {}}, view);
        const auto drawn = draw(frameOf(stage, view));
        EXPECT_LE(pixelsApart(drawn, expected, 2), 1) << name(view.kind) << view.index;
        EXPECT_GT(largestDifference(drawn, expected) + 1, 0);
    }
}

// Three segments, one hidden: labels of it are there, but no membership.
struct Segments {
    explicit Segments(Stage& stage) {
        const auto labelOf = [](glm::dvec3 p) { return p.x < 8 ? 1 : p.y < 9 ? 2 : 3; };
        const auto membershipOf = [=](glm::dvec3 p) {
            const double d = glm::length((p - glm::dvec3(11, 8, 6)) / glm::dvec3(9, 7, 5));
            const double smooth = std::clamp(0.5 + 2 * (1 - d), 0.0, 1.0);
            return labelOf(p) == 3 ? std::min(smooth, 0.3) : smooth;
        };
        stage.segments(
            membershipOf, [](glm::dvec3) { return 0; }, labelOf);
        stage.frame.segmentColours.entries[1] = {0.8F, 0.1F, 0.1F, 1};
        stage.frame.segmentColours.entries[2] = {0.1F, 0.2F, 0.9F, 1};
        stage.frame.segmentColours.entries[3] = {0.1F, 0.9F, 0.2F, 0};
        const glm::ivec3 dims = stage.volume.geometry.dims;
        for (int k = 0; k < dims.z; ++k) {
            for (int j = 0; j < dims.y; ++j) {
                for (int i = 0; i < dims.x; ++i) {
                    // As the texture of 16 bits holds it.
                    membership.push_back(float(std::lround(65535 * membershipOf({i, j, k}))) / 65535.0F);
                    labels.push_back(std::uint8_t(labelOf({i, j, k})));
                }
            }
        }
    }
    std::vector<float> membership;
    std::vector<std::uint8_t> labels;
};

TEST_F(SliceRendererTest, SegmentsCoverWhatBelongsToThem) {
    Stage stage(noise(), {-200, 250});
    const Segments segments(stage);
    for (const bool isSmooth : {false, true}) {
        for (const SliceView& view : views(stage.volume.geometry)) {
            SliceFrame frame = frameOf(stage, view);
            frame.isSmooth = isSmooth;
            const auto expected = reference::drawSlice({&stage.volume,
                                                        {-200, 250},
                                                        segments.membership,
                                                        segments.labels,
                                                        frame.segmentColours,
                                                        isSmooth},
                                                       view);
            // On smooth borders a pixel is covered in part.
            const int allowed = isSmooth ? view.size.x * view.size.y / 15 : 2;
            EXPECT_LE(pixelsApart(draw(frame), expected, 2), allowed) << name(view.kind) << isSmooth;
        }
    }
}

// The outline of a square of voxels, in nearest mode: the pixels within its width of the border, and no
// others.
TEST_F(SliceRendererTest, OutlinesRunAlongTheInside) {
    auto volume =
        phantom::makePhantom({12, 12, 3}, volume::ScalarType::UInt8, [](glm::dvec3) { return 120; });
    Stage stage(std::move(volume), {0, 200});
    const auto inside = [](glm::dvec3 p) { return p.x >= 3 && p.x <= 8 && p.y >= 3 && p.y <= 8 ? 1.0 : 0.0; };
    stage.segments(
        inside, [](glm::dvec3) { return 0; }, [&](glm::dvec3 p) { return inside(p); });
    stage.frame.segmentColours.entries[1] = {1, 0, 0, 1};
    SliceFrame frame = frameOf(stage, {SliceKind::Axial, 1, {0, 0}, 0.1, {120, 120}});
    frame.isSmooth = false;
    frame.outlinePixels = 2;
    const auto picture = draw(frame);
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 120; ++x) {
            const int depth = std::min({x - 30, 89 - x, y - 30, 89 - y}); // whole pixels inside
            const int red = picture.pixel(x, y)[0];
            const int green = picture.pixel(x, y)[1];
            if (depth < 0) {
                EXPECT_EQ(red, 153);
                EXPECT_EQ(green, 153);
            } else if (depth < 2) {
                EXPECT_EQ(red, 255);
                EXPECT_EQ(green, 0);
            } else if (depth > 3) {
                EXPECT_NEAR(green, 0.6 * 153, 1);
            }
        }
    }
}

TEST_F(SliceRendererTest, LooksOfSegmentsAreRespected) {
    Stage stage(noise(), {-200, 250});
    const Segments segments(stage);
    const SliceView view{SliceKind::Axial, 6, {0, 0}, 0.3, {90, 60}};
    const auto opaque = draw(frameOf(stage, view));
    stage.frame.segmentColours.entries[1].a = 0.4F;
    const auto translucent = draw(frameOf(stage, view));
    stage.frame.segmentColours.entries[1].a = 0;
    stage.frame.segmentColours.entries[2].a = 0;
    SliceFrame hidden = frameOf(stage, view);
    hidden.scene.segmentation = nullptr;
    const auto none = draw(hidden);
    EXPECT_GT(image::Image(opaque).rgba.size(), 0U);
    double strong = 0;
    double weak = 0;
    for (std::size_t i = 0; i < none.rgba.size(); ++i) {
        strong += std::abs(int(opaque.rgba[i]) - int(none.rgba[i]));
        weak += std::abs(int(translucent.rgba[i]) - int(none.rgba[i]));
    }
    EXPECT_GT(strong, 1.2 * weak);
    EXPECT_GT(weak, 0);
}

TEST_F(SliceRendererTest, WhatIsCutIsDarkAndOnlyThere) {
    auto volume =
        phantom::makePhantom({40, 20, 20}, volume::ScalarType::UInt8, [](glm::dvec3) { return 200; });
    Stage stage(std::move(volume), {0, 200});
    const SliceView view{SliceKind::Axial, 10, {0, 0}, 0.5, {80, 40}};
    const auto whole = draw(frameOf(stage, view));
    stage.cutAbove(20);
    for (const auto seen : {field::SculptureView::Cut, field::SculptureView::Probe}) {
        stage.view(seen);
        const auto picture = draw(frameOf(stage, view));
        for (int x = 0; x < 80; ++x) { // voxel (x + 0.5) / 2 - 0.5; the border at pixel 41
            const bool isHidden = (x > 41) == (seen == field::SculptureView::Cut);
            if (std::abs(x - 41) > 3) {
                EXPECT_EQ(whole.pixel(x, 20)[0], 255);
                EXPECT_EQ(picture.pixel(x, 20)[0] < 100, isHidden);
                EXPECT_EQ(picture.pixel(x, 20)[0] == 255, !isHidden);
            }
        }
    }
    stage.view(field::SculptureView::Whole);
    EXPECT_EQ(draw(frameOf(stage, view)).rgba, whole.rgba);
}

TEST_F(SliceRendererTest, TransferFunctionsColourWhatTheyShow) {
    auto volume = phantom::makePhantom({40, 20, 20}, volume::ScalarType::UInt8,
                                       [](glm::dvec3 p) { return p.x < 20 ? 50 : 200; });
    Stage stage(std::move(volume), {0, 200});
    TransferFunction function;
    function.points = {{150, 0, {255, 0, 0}}, {180, 1, {255, 0, 0}}, {255, 1, {255, 0, 0}}};
    stage.classify(function);
    SliceFrame frame = frameOf(stage, {SliceKind::Axial, 10, {0, 0}, 0.5, {80, 40}});
    frame.classification = stage.frame.classification;
    EXPECT_EQ(draw(frame).pixel(70, 20)[0], draw(frame).pixel(70, 20)[1]) << "coloured unasked";
    frame.tintsVisible = true;
    const auto picture = draw(frame);
    EXPECT_EQ(picture.pixel(10, 20)[0], picture.pixel(10, 20)[1]); // grey
    EXPECT_GT(picture.pixel(70, 20)[0], 250);
    EXPECT_LT(picture.pixel(70, 20)[1], 5);
}

TEST_F(SliceRendererTest, ValuesOfTheWindowGoFromBlackToWhiteWhateverIsDisplayed) {
    const Stage stage(noise(), {-200, 250});
    for (const Range window : {Range{-50, 30}, Range{-1000, 4000}, Range{100, 100}}) {
        for (const SliceView& view : views(stage.volume.geometry)) {
            SliceFrame frame = frameOf(stage, view);
            frame.window = window;
            frame.isSmooth = false;
            // One value: what lies below is black, all else white.
            const Range range = window.width() > 0 ? window : Range{window.lo - 1e-6, window.hi};
            const auto expected = reference::drawSlice({&stage.volume, range, {}, {}, {}, false}, view);
            EXPECT_LE(pixelsApart(draw(frame), expected, 1), 1) << name(view.kind) << view.index;
        }
    }
}

TEST_F(SliceRendererTest, TintsWhatIsDisplayedAndNothingElse) {
    const Stage stage(noise(), {-200, 250});
    const SliceView view{SliceKind::Axial, 5, {0, 0}, 0.1, {200, 200}};
    SliceFrame frame = frameOf(stage, view);
    frame.isSmooth = false;
    const auto grey = draw(frame);
    frame.tintsVisible = true;
    frame.visible = {20, 110};
    const auto tinted = draw(frame);
    const SliceGeometry geometry(stage.volume.geometry, view.kind);
    int inside = 0;
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const glm::dvec3 p = geometry.voxelAt(view.placeAt({x + 0.5, y + 0.5}), view.index);
            const glm::dvec3 fromBorder = glm::abs(glm::fract(p) - 0.5);
            const glm::ivec3 voxel(glm::floor(p + 0.5));
            const bool isInGrid = glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) &&
                                  glm::all(glm::lessThan(voxel, stage.volume.geometry.dims));
            if (!isInGrid || fromBorder.x < 1e-3 || fromBorder.y < 1e-3) {
                continue; // rounding decides which voxel it is
            }
            const bool isVisible = frame.visible.contains(stage.volume.at(voxel));
            const auto* pixel = tinted.pixel(x, y);
            EXPECT_EQ(pixel[0] > pixel[2] + 20, isVisible) << x << ' ' << y;
            EXPECT_TRUE(isVisible || pixel[0] == grey.pixel(x, y)[0]) << x << ' ' << y;
            inside += isVisible ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 500);
}

} // namespace
} // namespace vs::render
