// SPDX-License-Identifier: Apache-2.0
// How sketches end, and that what is shown of them is what they come to.
#include "model/segments/growth_controller.h"
#include "mouse.h"
#include "studio/document/document_facts.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/sweep_tool.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QTest>

namespace vs::desktop {
namespace {

using studio::Shape;

class Strokes : public testing::Test {
protected:
    void SetUp() override {
        w.window().resize(1100, 760);
        w.open();
        w.studio().growth().setAutoStart(false);
        w.studio().hand().setShape(Shape::Polyline);
        w.view().setFocus();
    }
    void TearDown() override {
        w.studio().hand().tool().clear();
        w.studio().hand().setShape(Shape::FreeForm);
        w.studio().growth().setAutoStart(true);
        EXPECT_EQ(w.studio().host().gl().errorCount(), 0);
    }
    void choose(Tool& tool) {
        w.studio().hand().take(tool);
        w.settle();
    }
    const std::vector<studio::Operation>& log() { return w.studio().host().document()->log(); }
    std::size_t count() { return w.studio().host().facts()->edits->done; }
    template <class Operation>
    const Operation& last() {
        return std::get<Operation>(log().back());
    }
    void corners(const std::vector<QPointF>& places) {
        for (const QPointF place : places) {
            mouse.click(place);
        }
    }
    void enter() { QTest::keyClick(&w.view(), Qt::Key_Return); }
    // The pixels of an overlay's path that its fill or its line covers.
    QImage covered(const QPainterPath& path, double width) {
        QImage image(w.view().size(), QImage::Format_Grayscale8);
        image.fill(0);
        QPainter painter(&image);
        if (width > 0) {
            painter.strokePath(path, QPen(Qt::white, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        } else {
            painter.fillPath(path, Qt::white);
        }
        return image;
    }
    static int whiteOf(const QImage& image) {
        int white = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                white += qGray(image.pixel(x, y)) > 127 ? 1 : 0;
            }
        }
        return white;
    }

    StudioWindow& w = StudioWindow::instance();
    Mouse mouse{w};
    const QPointF a{0.45, 0.45};
    const QPointF b{0.55, 0.46};
    const QPointF c{0.5, 0.55};
};

TEST_F(Strokes, APolylineEndsByEnter) {
    choose(w.tools().get<ScissorsTool>());
    const std::size_t before = count();
    corners({a, b, c});
    mouse.move({0.3, 0.3}); // where no corner was set
    EXPECT_EQ(count(), before);
    enter();
    w.settle();
    ASSERT_EQ(count(), before + 1);
    EXPECT_EQ(last<studio::Scissors>().outline.points.size(), 3U);
}

TEST_F(Strokes, APolylineEndsByADoubleClickWhichIsItsLastCorner) {
    choose(w.tools().get<ScissorsTool>());
    const std::size_t before = count();
    corners({a, b});
    mouse.doubleClick(c);
    w.settle();
    ASSERT_EQ(count(), before + 1);
    EXPECT_EQ(last<studio::Scissors>().outline.points.size(), 3U);
}

TEST_F(Strokes, APolylineEndsOnItsFirstCornerAndNotBesideIt) {
    choose(w.tools().get<ScissorsTool>());
    const std::size_t before = count();
    const QPointF pixel(1.0 / w.view().width(), 1.0 / w.view().height());
    corners({a, b, c, {a.x() + 16 * pixel.x(), a.y()}});
    EXPECT_EQ(count(), before) << "16 pixels off is a corner of its own";
    mouse.click({a.x() + 6 * pixel.x(), a.y() + 5 * pixel.y()});
    w.settle();
    ASSERT_EQ(count(), before + 1);
    EXPECT_EQ(last<studio::Scissors>().outline.points.size(), 4U);
}

TEST_F(Strokes, EscapeDropsAPolylineOfEveryTool) {
    for (Tool* tool : std::initializer_list<Tool*>{&w.tools().get<ScissorsTool>(), &w.tools().get<PeelTool>(),
                                                   &w.tools().get<SeedTool>(), &w.tools().get<SweepTool>()}) {
        choose(*tool);
        const QString begin = tool->hint();
        corners({a, b, c});
        ASSERT_TRUE(tool->isSketching()) << tool->name().toStdString();
        w.trigger("clearSketch");
        EXPECT_FALSE(tool->isSketching()) << tool->name().toStdString();
        EXPECT_EQ(tool->hint(), begin);
        enter();
        w.settle();
        EXPECT_EQ(count(), 0U) << tool->name().toStdString();
    }
}

TEST_F(Strokes, MasksEndByEnterToo) {
    for (const char* name : {"peelTool", "drillTool", "laserTool", "sweepTool"}) {
        w.trigger(name);
        w.settle();
        corners({a, b, c});
        ASSERT_TRUE(w.studio().hand().tool().isSketching()) << name;
        enter();
        EXPECT_FALSE(w.studio().hand().tool().isSketching()) << name;
        EXPECT_FALSE(w.studio().hand().tool().overlays().empty()) << name << " has no mask";
    }
    EXPECT_EQ(count(), 0U) << "a mask alone cuts nothing";
}

TEST_F(Strokes, TheFirstCornerLightsUpWhereAClickClosesThePolyline) {
    auto& tool = w.tools().get<PeelTool>();
    choose(tool);
    const auto ring = [&] { return tool.overlays().back(); };
    corners({a, b});
    mouse.move(a);
    const auto plain = tool.overlays().size();
    corners({c});
    mouse.move({0.5, 0.5});
    ASSERT_EQ(tool.overlays().size(), plain + 1) << "from three corners on it can be closed";
    const double far = ring().path.boundingRect().width();
    EXPECT_EQ(ring().fill, 0);
    w.photograph(w.view(), "polyline_open");
    mouse.move({a.x() + 6.0 / w.view().width(), a.y()});
    EXPECT_GT(ring().path.boundingRect().width(), far);
    EXPECT_GT(ring().fill, 0.3);
    const QPointF middle = ring().path.boundingRect().center();
    EXPECT_NEAR(middle.x(), a.x() * w.view().width(), 1.5);
    w.photograph(w.view(), "polyline_closing");
}

TEST_F(Strokes, APolylineOfTwoPointsSeedsWhatItShows) {
    auto& tool = w.tools().get<SeedTool>();
    choose(tool);
    tool.setWidth(9);
    mouse.click(a);
    mouse.click(b);
    mouse.move({0.3, 0.6});
    const auto shown = tool.overlays().front();
    w.photograph(w.view(), "seed_line");
    EXPECT_EQ(shown.fill, 0) << "a line, not an area";
    EXPECT_EQ(shown.width, 9);
    enter();
    w.settle();
    const studio::Seed seed = last<studio::Seed>();
    ASSERT_EQ(seed.strokes.size(), 1U);
    EXPECT_EQ(seed.strokes.front().points.size(), 2U);
    EXPECT_FALSE(seed.voxels.empty());
    // Free-hand between the same places.
    studio::Seed free = seed;
    free.voxels.clear();
    free.strokes.front().shape = Shape::FreeForm;
    ASSERT_TRUE(w.studio().editor().apply(free));
    EXPECT_EQ(last<studio::Seed>().voxels, seed.voxels);
    tool.setWidth(5);
}

TEST_F(Strokes, ASeedLineThatIsClosedSeedsItsLastStretchToo) {
    auto& tool = w.tools().get<SeedTool>();
    choose(tool);
    corners({a, b, c});
    mouse.move(a);
    const auto shown = tool.overlays().front().path;
    EXPECT_LT(QLineF(shown.pointAtPercent(1), shown.pointAtPercent(0)).length(), 1);
    mouse.click(a);
    w.settle();
    const auto& points = last<studio::Seed>().strokes.front().points;
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points.front(), points.back());
}

TEST_F(Strokes, APictureSeedsItsArea) {
    QImage star(64, 64, QImage::Format_RGB32);
    star.fill(Qt::black);
    QPainter(&star).fillRect(8, 8, 48, 48, Qt::white);
    const auto path = StudioWindow::folder / "square.png";
    ASSERT_TRUE(star.save(QString::fromStdString(path.string())));
    ASSERT_TRUE(w.studio().hand().setStencil(path));
    auto& tool = w.tools().get<SeedTool>();
    choose(tool);
    mouse.press(a);
    mouse.move({0.5, 0.5});
    mouse.move({0.55, 0.6});
    const auto shown = tool.overlays().front();
    EXPECT_GT(shown.fill, 0);
    const int pixels = whiteOf(covered(shown.path, 0));
    w.photograph(w.view(), "seed_picture");
    mouse.release({0.55, 0.6});
    w.settle();
    const studio::Seed seed = last<studio::Seed>();
    EXPECT_EQ(seed.strokes.front().shape, Shape::Stencil);
    // The same area as a rectangle seeds the same voxels.
    studio::Seed box = seed;
    box.voxels.clear();
    glm::dvec2 lo = box.strokes.front().points.front();
    glm::dvec2 hi = lo;
    for (const glm::dvec2 point : box.strokes.front().points) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    EXPECT_NEAR((hi.x - lo.x) * (hi.y - lo.y), pixels, 0.03 * pixels);
    box.strokes = {{Shape::Rectangle, {lo, hi}}};
    ASSERT_TRUE(w.studio().editor().apply(box));
    const auto& boxed = last<studio::Seed>().voxels;
    EXPECT_GT(seed.voxels.size(), 40U);
    EXPECT_NEAR(double(seed.voxels.size()), double(boxed.size()), 0.03 * double(boxed.size()));
}

TEST_F(Strokes, ThePictureHoldsStillUnderAPolyline) {
    choose(w.tools().get<ScissorsTool>());
    const auto camera = w.studio().view().shown().camera;
    corners({a, b});
    const QPoint middle = w.view().mapTo(&w.window(), w.view().rect().center());
    auto* window = w.window().windowHandle();
    QTest::mousePress(window, Qt::MiddleButton, {}, middle);
    QTest::mouseMove(window, middle + QPoint(30, 30));
    QTest::mouseRelease(window, Qt::MiddleButton, {}, middle + QPoint(30, 30));
    EXPECT_EQ(w.studio().view().shown().camera, camera);
    corners({c, a});
    w.settle();
    EXPECT_EQ(last<studio::Scissors>().outline.points.size(), 3U);
}

TEST_F(Strokes, AnotherShapeDropsThePolylineUnderWay) {
    choose(w.tools().get<ScissorsTool>());
    corners({a, b});
    w.trigger("ellipse");
    EXPECT_FALSE(w.studio().hand().tool().isSketching());
    mouse.drag({a, {0.5, 0.5}, {0.55, 0.55}});
    w.settle();
    EXPECT_EQ(last<studio::Scissors>().outline.shape, Shape::Ellipse);
}

} // namespace
} // namespace vs::desktop
