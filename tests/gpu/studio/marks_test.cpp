// SPDX-License-Identifier: Apache-2.0
// Marks: they are where the pen was, stay on the material, and are undone, saved and drawn while the pen
// moves.
#include "gpu/gl_test.h"
#include "gpu/studio/test_head.h"
#include "gpu/studio/test_tools.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "property.h"
#include "render/rays/picker.h"
#include "studio/document/document_content.h"
#include "studio/document/document_facts.h"
#include "studio/document/document_state.h"
#include "studio/document/live_mark.h"
#include "studio/json/operation_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vs::studio {
namespace {

constexpr glm::ivec2 kSize{400, 300};
constexpr double kRadius = 38; // voxels

class MarksTest : public test::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        caster_.emplace();
        picker_.emplace();
    }
    void TearDown() override {
        caster_.reset();
        picker_.reset();
        GlTest::TearDown();
    }
    image::Image picture(Document& document, const View& view, int samples = 1) {
        document.showView(view);
        render::Frame frame = document.frame(kSize);
        frame.samples = samples;
        caster_->render(frame);
        return caster_->readPicture();
    }

    std::vector<field::SurfacePoint> pick(Document& document, const View& view,
                                          std::span<const glm::vec2> pixels) {
        document.showView(view);
        return picker_->pickPoints(document.frame(kSize), pixels);
    }

    std::optional<render::RayCaster> caster_;
    std::optional<render::Picker> picker_;
};

volume::Volume ball() { return phantom::makeBall(glm::ivec3(88), glm::dvec3(43.5), kRadius); }

View viewOf(double azimuth, double zoom, render::Projection projection, glm::dvec2 pan = {}) {
    View view;
    view.range = {100, 255};
    view.camera.azimuthDegrees = azimuth;
    view.camera.elevationDegrees = 10;
    view.camera.zoom = zoom;
    view.camera.projection = projection;
    view.camera.panMm = pan;
    return view;
}

Mark lineOf(std::vector<glm::dvec2> points, const View& view, double widthMm = 6) {
    Mark mark;
    mark.sketch = {Shape::Polyline, std::move(points)};
    mark.widthMm = widthMm;
    mark.colour = {0.1, 0.2, 0.9};
    mark.canvas = Canvas{view, kSize};
    return mark;
}

// The places of the surface under a line, a quarter of a pixel apart: voxel space, which here is one of mm.
std::vector<glm::vec2> along(glm::dvec2 from, glm::dvec2 to) {
    std::vector<glm::vec2> pixels;
    const int count = int(4 * glm::distance(from, to));
    for (int i = 0; i <= count; ++i) {
        pixels.emplace_back(glm::mix(from, to, double(i) / count));
    }
    return pixels;
}

bool isMarked(const image::Image& picture, int x, int y) {
    const std::uint8_t* p = &picture.rgba[4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
    return int(p[2]) > int(p[0]) + 20;
}

// The line drawn on a ball covers what lies within half its width of the pen's way on the surface, to half a
// pixel: from where it was drawn, from another side, from near, with either projection.
TEST_F(MarksTest, AreWhereThePenWas) {
    const glm::dvec2 from(150, 130);
    const glm::dvec2 to(240, 180);
    for (const auto projection : {render::Projection::Perspective, render::Projection::Orthographic}) {
        const View drawnOn = viewOf(0, 1, projection);
        Document document(ball());
        document.apply(lineOf({from, to}, drawnOn));
        std::vector<glm::dvec3> way;
        for (const auto& point : pick(document, drawnOn, along(from, to))) {
            ASSERT_GT(point.voxel.w, 0);
            way.emplace_back(point.voxel);
        }
        for (const View& view :
             {drawnOn, viewOf(28, 1, projection), viewOf(5, 4, projection),
              viewOf(2, projection == render::Projection::Perspective ? 5 : 9, projection)}) {
            const image::Image marked = picture(document, view);
            std::vector<glm::vec2> pixels;
            for (int y = 0; y < kSize.y; ++y) {
                for (int x = 0; x < kSize.x; ++x) {
                    pixels.emplace_back(x + 0.5, y + 0.5);
                }
            }
            const auto surface = pick(document, view, pixels);
            const auto rays = document.frame(kSize).rays;
            int wrong = 0;
            int inside = 0;
            for (int i = 0; i < kSize.x * kSize.y; ++i) {
                const field::SurfacePoint& point = surface[std::size_t(i)];
                const glm::dvec3 voxel(point.voxel);
                const glm::dvec3 world(document.volume().geometry.worldFromVoxel * glm::dvec4(voxel, 1));
                const glm::dvec3 towardsEye = -rays.through(pixels[std::size_t(i)]).direction;
                const double slant = glm::dot(glm::dvec3(point.normal), towardsEye);
                if (point.voxel.w == 0 || slant < 0.3) {
                    continue; // seen edge on, where half a pixel is far on the surface
                }
                double nearest = 1e9;
                for (const glm::dvec3& place : way) {
                    nearest = std::min(nearest, glm::distance(place, voxel));
                }
                const double halfPixel = 0.5 * rays.pixelMm(world) / slant;
                const bool isInside = nearest < 3 - halfPixel;
                const bool isOutside = nearest > 3 + halfPixel;
                inside += isInside ? 1 : 0;
                const bool is = isMarked(marked, i % kSize.x, i / kSize.x);
                wrong += (isInside && !is) || (isOutside && is) ? 1 : 0;
            }
            EXPECT_GT(inside, 500) << "zoom " << view.camera.zoom << ", projection " << int(projection);
            // From near a pixel is a small part of a texel, a quarter of whose width edges may be off.
            const double texelPixels =
                document.marks()->grid().texelMm(document.volume().geometry) / rays.pixelMm({0, 0, 0});
            EXPECT_LE(wrong, texelPixels < 2 ? 2 : inside / 100)
                << "azimuth " << view.camera.azimuthDegrees << ", zoom " << view.camera.zoom;
        }
    }
}

TEST_F(MarksTest, StayOnTheMaterialWhateverIsDone) {
    Document document(test::testHead());
    const View skin = test::testCanvas({50, 255}).view;
    document.showView(skin);
    document.apply(lineOf({{170, 120}, {230, 120}}, skin, 5));
    const image::Image before = picture(document, skin);
    ASSERT_TRUE(isMarked(before, 200, 120));
    // A range that moves the surface a little, and what lies below it, which nobody has marked.
    EXPECT_TRUE(isMarked(picture(document, test::testCanvas({90, 255}).view), 200, 120));
    Peel peel = test::somePeel(6);
    peel.mask = test::ellipseAt(200, 120, 40, 30);
    document.apply(peel);
    EXPECT_FALSE(isMarked(picture(document, skin), 200, 120))
        << "the layer below the one that was peeled off";
    document.apply(Undo{});
    // Through the mark: its other part stays beside the hole.
    Drill drill = test::drillOf(test::ellipseAt(185, 120, 8, 8), test::testCanvas());
    drill.stroke = {{{185, 120}, 1}};
    document.apply(drill);
    const image::Image drilled = picture(document, skin);
    EXPECT_FALSE(isMarked(drilled, 185, 120));
    EXPECT_TRUE(isMarked(drilled, 215, 120));
    document.apply(UnCut{});
    EXPECT_EQ(image::compare(picture(document, skin), before).max, 0);
}

// Where a mark was cut through, the section has it as deep as the ink goes.
TEST_F(MarksTest, AreSeenOnCutFaces) {
    Document document(ball());
    const View view = viewOf(0, 1, render::Projection::Orthographic);
    document.showView(view);
    Mark area;
    area.kind = Mark::Kind::Area;
    area.sketch = test::ellipseAt(200, 150, 60, 60);
    area.colour = {0.1, 0.2, 0.9};
    area.depthMm = 6;
    area.canvas = Canvas{view, kSize};
    document.apply(area);
    Clip clip;
    clip.planes = {{document.volume().geometry.worldFromVoxel * glm::dvec4(43.5, 43.5, 43.5, 1), {0, 0, 1}}};
    document.apply(clip);
    // From above: the section's front rim is inked, its middle is not.
    View above = view;
    above.camera.elevationDegrees = 89;
    const image::Image section = picture(document, above);
    const auto rays = document.frame(kSize).rays;
    const auto& geometry = document.volume().geometry;
    int inked = 0;
    for (int deep = 1; deep <= 12; ++deep) {
        const glm::dvec3 voxel(43.5, 43.5 - kRadius + deep, 43.2);
        const glm::dvec2 pixel = rays.project(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1)));
        const bool is = isMarked(section, int(pixel.x), int(pixel.y));
        EXPECT_TRUE(is || deep > 5) << deep << " mm below the surface";
        EXPECT_FALSE(is && deep > 7) << deep << " mm below the surface";
        inked += is ? 1 : 0;
    }
    EXPECT_GT(inked, 3);
}

// The scan's border is a surface too: a head that ends at its last slice. And pictures and exports agree.
TEST_F(MarksTest, AreWholeAtTheGridsBorders) {
    volume::Volume box =
        phantom::makePhantom({24, 24, 24}, volume::ScalarType::UInt8, [](glm::dvec3) { return 200.0; });
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
        Document document(box);
        View view = viewOf(azimuth, 1, render::Projection::Orthographic);
        view.camera.elevationDegrees = 0;
        document.showView(view);
        Mark area;
        area.kind = Mark::Kind::Area;
        area.sketch = test::ellipseAt(200, 150, 40, 40);
        area.colour = {0, 0, 1};
        area.canvas = Canvas{view, kSize};
        document.apply(area);
        const image::Image marked = picture(document, view);
        const std::uint8_t* p = &marked.rgba[std::size_t(4) * (150 * 400 + 200)];
        EXPECT_LT(int(p[0]), 40) << "azimuth " << azimuth << ": all of the colour is there";
        EXPECT_GT(int(p[2]), 80);
        const std::vector<glm::vec2> middle{{200, 150}};
        const glm::dvec3 voxel(pick(document, view, middle).front().voxel);
        EXPECT_NEAR(document.marks()->colourAt(voxel).w, 1, 1e-6);
    }
}

// Ink has the width that was asked for where the voxels lie now.
TEST_F(MarksTest, FollowACorrectedGeometry) {
    Document document(test::testHead());
    const View view = test::testCanvas().view;
    document.showView(view);
    document.apply(lineOf({{170, 120}, {230, 120}}, view, 5));
    CorrectGeometry correct;
    correct.spacing = glm::dvec3(10, 10, 12);
    document.apply(correct);
    document.apply(RemoveMarks{});
    document.apply(lineOf({{170, 150}, {230, 150}}, view, 50));
    const image::Image fresh = picture(document, view);
    document.apply(Undo{});
    document.apply(Undo{});
    document.apply(lineOf({{170, 150}, {230, 150}}, view, 50)); // on the grid of the mark that was there
    const image::Image beside = picture(document, view);
    for (int y = 140; y < 165; ++y) {
        for (int x = 175; x < 225; ++x) {
            EXPECT_EQ(isMarked(fresh, x, y), isMarked(beside, x, y)) << x << ", " << y;
        }
    }
    EXPECT_TRUE(isMarked(beside, 200, 150));
}

TEST_F(MarksTest, AreUndoneToTheByteAndRedone) {
    Document document(test::testHead());
    const View view = test::testCanvas().view;
    document.showView(view);
    const image::Image clean = picture(document, view);
    std::vector<DocumentContent> states{contentOf(document)};
    std::vector<Operation> marks{lineOf({{170, 120}, {230, 120}}, view, 5),
                                 lineOf({{180, 100}, {200, 140}}, view, 3)};
    Mark area;
    area.kind = Mark::Kind::Area;
    area.sketch = test::ellipseAt(200, 130, 30, 12);
    area.opacity = 0.5;
    area.softMm = 3;
    area.canvas = Canvas{view, kSize};
    marks.emplace_back(area);
    Mark text = area;
    text.kind = Mark::Kind::Text;
    text.text = "R 1";
    text.widthMm = 1;
    text.canvas = Canvas{view, kSize};
    marks.emplace_back(text);
    Mark arrow = lineOf({{160, 90}, {220, 150}}, view, 2);
    arrow.kind = Mark::Kind::Arrow;
    arrow.dashMm = 4;
    marks.emplace_back(arrow);
    Mark eraser = lineOf({{150, 125}, {240, 118}}, view, 4);
    eraser.erases = true;
    marks.emplace_back(eraser);
    marks.emplace_back(RemoveMarks{});
    for (const Operation& mark : marks) {
        EXPECT_GT(document.apply(mark).voxelsTouched, 0U) << name(mark);
        states.push_back(contentOf(document));
    }
    for (std::size_t n = marks.size(); n > 0; --n) {
        document.apply(Undo{});
        EXPECT_TRUE(*document.marks() == *states[n - 1].marks);
    }
    EXPECT_TRUE(document.marks()->isEmpty());
    EXPECT_EQ(picture(document, view).rgba, clean.rgba);
    for (std::size_t n = 1; n <= marks.size(); ++n) {
        document.apply(Redo{});
        EXPECT_TRUE(*document.marks() == *states[n].marks);
    }
    // What the log says, read again from its text, comes to the same.
    document.apply(Undo{});
    Document again(test::testHead());
    for (const Operation& operation : document.log()) {
        again.apply(operationFromJson(nlohmann::ordered_json::parse(toJson(operation).dump()), "test"));
    }
    EXPECT_TRUE(*again.marks() == *document.marks());
    EXPECT_FALSE(again.marks()->isEmpty());
}

// A line that is seen while it is drawn is the one that its operation says.
TEST_F(MarksTest, ALineInHandIsTheOneThatIsLogged) {
    test::checkProperty(6, [&] {
        Document document(test::testHead());
        const View view = test::testCanvas().view;
        document.showView(view);
        Mark line;
        line.widthMm = 1 + *test::below(6);
        line.softMm = *test::below(2);
        line.dashMm = *test::below(2) * 4;
        line.pressureSets = Mark::Pressure(*test::below(3));
        line.canvas = Canvas{view, kSize};
        document.mark().begin(line);
        const int count = 1 + *test::below(6);
        for (int i = 0; i < count; ++i) {
            document.mark().drawAt(
                {{150.0 + *test::below(100), 90.0 + *test::below(80)}, 0.1 + *test::below(10) * 0.1});
        }
        RC_ASSERT(document.facts()->isStrokeOpen());
        const field::SharedMarks drawn = document.marks();
        document.mark().commit();
        RC_ASSERT(*document.marks() == *drawn);
        Document again(test::testHead());
        for (const Operation& operation : document.log()) {
            again.apply(operation);
        }
        RC_ASSERT(*again.marks() == *drawn);
    });
}

TEST_F(MarksTest, ALineThatIsDroppedLeavesNoTrace) {
    Document document(test::testHead());
    const View view = test::testCanvas().view;
    document.showView(view);
    const DocumentContent before = contentOf(document);
    Mark line;
    line.canvas = Canvas{view, kSize};
    document.mark().begin(line);
    document.mark().drawAt({{200, 120}, 1});
    EXPECT_FALSE(document.marks()->isEmpty());
    document.mark().discard();
    EXPECT_TRUE(differences(before, contentOf(document), "before", "after").empty());
    // Beside the head there is nothing to mark, and no step.
    document.mark().begin(line);
    document.mark().drawAt({{5, 5}, 1});
    EXPECT_EQ(document.mark().commit().voxelsTouched, 0U);
    EXPECT_TRUE(differences(before, contentOf(document), "before", "after").empty());
}

TEST_F(MarksTest, AreRefusedInOneLine) {
    Document document(test::testHead());
    Mark text;
    text.kind = Mark::Kind::Text;
    text.sketch = {Shape::FreeForm, {{200, 120}}};
    text.text = "a#b";
    EXPECT_THROW(document.apply(text), Error);
    text.text = "R";
    text.sketch.points = {{3, 3}};
    EXPECT_THROW(document.apply(text), Error) << "there is nothing to write on";
    Mark arrow;
    arrow.kind = Mark::Kind::Arrow;
    arrow.sketch = {Shape::FreeForm, {{200, 120}}};
    EXPECT_THROW(document.apply(arrow), Error);
    EXPECT_THROW(document.apply(RemoveMarks{}), Error);
    EXPECT_THROW(document.apply(SaveMarks{"marks.nrrd"}), Error);
    EXPECT_TRUE(document.log().empty());
}

// Every mode that shows surfaces shows marks on them, and slices do.
TEST_F(MarksTest, AreSeenInModesWithSurfacesAndOnSlices) {
    Document document(test::testHead());
    View view = test::testCanvas().view;
    document.showView(view);
    document.apply(test::brainSeed());
    Grow grow;
    grow.generations = 40;
    document.apply(grow);
    document.apply(lineOf({{170, 120}, {230, 120}}, view, 8));
    for (const auto mode : {render::Mode::Surface, render::Mode::Segment, render::Mode::Volume}) {
        view.mode = mode;
        const image::Image marked = picture(document, view);
        document.apply(Undo{});
        const image::Image clean = picture(document, view);
        document.apply(Redo{});
        EXPECT_GT(image::compare(marked, clean).max, 40) << int(mode);
    }
    // In overlay mode it is the segments that are marked.
    view.mode = render::Mode::Overlay;
    const image::Image clean = picture(document, view);
    document.apply(lineOf({{170, 130}, {230, 130}}, view, 8));
    EXPECT_GT(image::compare(picture(document, view), clean).max, 40);
    // And a slice through the first line, which lies where its middle was picked.
    view.mode = render::Mode::Surface;
    const std::vector<glm::vec2> middle{{200, 120}};
    const glm::dvec3 voxel(pick(document, view, middle).front().voxel);
    render::SliceView slice;
    slice.index = int(std::lround(voxel.z));
    slice.size = kSize;
    render::SliceRenderer slices;
    slices.render(document.slice(slice));
    const image::Image marked = slices.readPicture();
    document.apply(Undo{});
    document.apply(Undo{});
    slices.render(document.slice(slice));
    EXPECT_GT(image::compare(marked, slices.readPicture()).max, 40);
}

TEST_F(MarksTest, NothingMarkedTakesNoMemory) {
    Document document(test::testHead());
    const View view = test::testCanvas().view;
    picture(document, view);
    EXPECT_EQ(document.frame(kSize).scene.marks, nullptr);
    EXPECT_EQ(document.marks()->memoryBytes(), 0U);
    document.apply(lineOf({{190, 120}, {195, 120}}, view, 2));
    EXPECT_LE(document.marks()->bricks().size(), 8U) << "a dot is in a few bricks";
    Mark eraser = lineOf({{150, 120}, {240, 120}}, view, 30);
    eraser.erases = true;
    document.apply(eraser);
    EXPECT_EQ(document.marks()->memoryBytes(), 0U);
    picture(document, view);
    EXPECT_EQ(document.frame(kSize).scene.marks, nullptr);
}

} // namespace
} // namespace vs::studio
