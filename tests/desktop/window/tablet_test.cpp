// SPDX-License-Identifier: Apache-2.0
// A pen with pressure, through the real window.
#include "model/segments/growth_controller.h"
#include "model/slices/slice_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/surface_queries.h"
#include "studio_window.h"
#include "tools/camera_tool.h"
#include "tools/drill_tool.h"
#include "tools/laser_tool.h"
#include "tools/paint_tool.h"
#include "tools/peel_tool.h"
#include "tools/seed_tool.h"

#include <gtest/gtest.h>

#include <QProgressBar>
#include <QSlider>
#include <QTest>

namespace vs::desktop {
namespace {

using End = StudioWindow::End;
using Touch = StudioWindow::Touch;

class Tablet : public testing::Test {
protected:
    void SetUp() override { w.open(); }
    void TearDown() override {
        w.leaveTablet();
        EXPECT_EQ(w.studio().host().gl().errorCount(), 0);
    }
    const std::vector<studio::Operation>& log() { return w.studio().host().document()->log(); }
    template <class Operation>
    const Operation& last() {
        for (auto it = log().rbegin(); it != log().rend(); ++it) {
            if (const auto* found = std::get_if<Operation>(&*it)) {
                return *found;
            }
        }
        throw std::runtime_error("no such operation was made");
    }
    std::optional<studio::Probe> look() {
        std::optional<studio::Probe> seen;
        // Nothing while things move.
        StudioWindow::wait("something to be seen", [&] {
            seen = w.studio().probe(centre());
            return seen || w.studio().isIdle();
        });
        return seen;
    }
    // What the tool lowers the surface by in the middle of the view, in steps.
    double sunk(Tool& tool, double pressure) {
        w.open();
        w.studio().hand().take(tool);
        const auto before = look();
        w.drawMask();
        w.stroke(w.view(), {{{0.5, 0.5}, pressure}});
        w.leaveTablet();
        w.settle();
        const auto after = look();
        EXPECT_TRUE(before && after);
        return before && after ? glm::distance(before->world, after->world) / step() : 0;
    }
    QPointF centre() { return {0.5 * w.view().width(), 0.5 * w.view().height()}; }
    double step() { return w.studio().host().geometry()->stepMm(); }

    StudioWindow& w = StudioWindow::instance();
};

TEST_F(Tablet, ADrillHoldsThePressuresAndTheTiltOfThePen) {
    w.studio().hand().take(w.tools().get<DrillTool>());
    w.drawMask();
    const std::vector<Touch> way{
        {{0.45, 0.5}, 0.25, {10, -5}}, {{0.5, 0.5}, 0.5, {12, -5}}, {{0.55, 0.503}, 0.875, {14, -5}}};
    w.stroke(w.view(), way);
    w.settle();
    const auto& drill = last<studio::Drill>();
    const glm::dvec2 scale = w.studio().view().devicePerLogical();
    ASSERT_EQ(drill.stroke.size(), way.size());
    for (std::size_t n = 0; n < way.size(); ++n) {
        const auto& point = drill.stroke[n];
        EXPECT_DOUBLE_EQ(point.pressure, way[n].pressure);
        EXPECT_NEAR(point.tiltDegrees.x, way[n].tilt.x(), 1e-5);
        EXPECT_NEAR(point.tiltDegrees.y, way[n].tilt.y(), 1e-5);
        // Finer than pixels.
        EXPECT_NEAR(point.pixel.x, way[n].place.x() * w.view().width() * scale.x, 1e-6);
        EXPECT_NEAR(point.pixel.y, way[n].place.y() * w.view().height() * scale.y, 1e-6);
    }
}

TEST_F(Tablet, DrillAndLaserGoAsDeepAsThePenPresses) {
    for (PenTool* tool : {static_cast<PenTool*>(&w.tools().get<DrillTool>()),
                          static_cast<PenTool*>(&w.tools().get<LaserTool>())}) {
        // In steps; the skull between 4 and 7 is not in the displayed range, so no floor can be seen there.
        for (const double depth : {3.0, tool->depth()}) {
            const double pressure = depth / tool->depth();
            // The picker's surface is refined to a hundredth of a voxel, the cut's floor is smoothed by the
            // data's and the sculpture's grids: half a step in all.
            EXPECT_NEAR(sunk(*tool, pressure), depth, 0.5)
                << tool->name().toStdString() << " at pressure " << pressure;
        }
    }
}

TEST_F(Tablet, AMousePressesAsItsSliderSays) {
    auto& slider = w.part<QSlider>("mousePressure");
    slider.setValue(40);
    w.studio().hand().take(w.tools().get<DrillTool>());
    w.drawMask();
    w.leaveTablet();
    const QPoint inWindow = w.view().mapTo(&w.window(), centre().toPoint());
    QTest::mousePress(w.window().windowHandle(), Qt::LeftButton, {}, inWindow);
    QTest::mouseRelease(w.window().windowHandle(), Qt::LeftButton, {}, inWindow);
    w.settle();
    slider.setValue(100);
    const auto& drill = last<studio::Drill>();
    ASSERT_EQ(drill.stroke.size(), 1U);
    EXPECT_DOUBLE_EQ(drill.stroke.front().pressure, 0.4);
}

TEST_F(Tablet, PeelGoesByTheWayOfThePenWhateverThePressure) {
    for (const double pressure : {0.1, 1.0}) {
        w.open();
        w.studio().hand().take(w.tools().get<PeelTool>());
        w.drawMask();
        const double down = 40.0 / w.view().height(); // logical pixels: four layers
        w.stroke(w.view(),
                 {{{0.5, 0.5}, pressure}, {{0.5, 0.5 + down / 2}, pressure}, {{0.5, 0.5 + down}, pressure}});
        w.settle();
        EXPECT_NEAR(last<studio::Peel>().layers, 4, 1e-9);
    }
}

TEST_F(Tablet, SeedsLandUnderThePen) {
    w.studio().growth().setAutoStart(false);
    w.studio().hand().take(w.tools().get<SeedTool>());
    w.stroke(w.view(), {{{0.45, 0.5}, 0.4}, {{0.5, 0.51}, 0.6}, {{0.55, 0.5}, 0.2}});
    w.settle();
    const auto& seed = last<studio::Seed>();
    ASSERT_EQ(seed.strokes.size(), 1U);
    EXPECT_FALSE(seed.voxels.empty());
    const auto& points = seed.strokes.front().points;
    EXPECT_NEAR(points.front().x, 0.45 * w.view().width() * w.studio().view().devicePerLogical().x, 1e-6);
    w.studio().growth().setAutoStart(true);
}

TEST_F(Tablet, ThePressureIsShownWhileThePenDraws) {
    w.studio().hand().take(w.tools().get<DrillTool>());
    auto& shown = w.part<QProgressBar>("penPressure");
    EXPECT_TRUE(shown.isVisible());
    w.drawMask();
    for (const double pressure : {0.25, 0.8}) {
        w.pen(QEvent::TabletPress, w.view(), {{0.5, 0.5}, pressure});
        EXPECT_EQ(shown.value(), std::lround(100 * pressure));
        EXPECT_EQ(shown.text(), QString("%1 %").arg(std::lround(100 * pressure)));
        if (pressure > 0.5) {
            w.photograph(w.window(), "pressure");
        }
        w.pen(QEvent::TabletRelease, w.view(), {{0.5, 0.5}});
    }
    EXPECT_EQ(shown.value(), 0) << "the pen was lifted";
}

TEST_F(Tablet, TheEraserPutsBackWhatTheTipTook) {
    auto& drill = w.tools().get<DrillTool>();
    w.studio().hand().take(drill);
    w.drawMask();
    const auto before = look();
    w.stroke(w.view(), {{{0.5, 0.5}, 1.0}});
    w.settle();
    EXPECT_FALSE(last<studio::Drill>().restores);
    const auto cut = look();
    w.leaveTablet();

    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}}, End::Eraser);
    EXPECT_TRUE(drill.isReversed()) << "seen before it is pressed";
    w.stroke(w.view(), {{{0.5, 0.5}, 1.0}}, End::Eraser);
    w.settle();
    EXPECT_TRUE(last<studio::Drill>().restores);
    w.leaveTablet(End::Eraser);
    EXPECT_FALSE(drill.isReversed()) << "the tip cuts again";
    w.settle();
    const auto after = look();
    ASSERT_TRUE(before && cut && after);
    EXPECT_GT(glm::distance(before->world, cut->world), 5 * step());
    EXPECT_LT(glm::distance(before->world, after->world), 0.25 * step());
}

TEST_F(Tablet, TheEraserOfAReversedToolCuts) {
    auto& peel = w.tools().get<PeelTool>();
    w.studio().hand().take(peel);
    peel.setReversed(true);
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}}, End::Eraser);
    EXPECT_FALSE(peel.isReversed());
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}});
    EXPECT_TRUE(peel.isReversed());
    // A tool that is left while the eraser is near is as it was.
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}}, End::Eraser);
    w.studio().hand().take(w.tools().get<SeedTool>());
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}}, End::Eraser);
    EXPECT_TRUE(peel.isReversed());
    EXPECT_TRUE(w.tools().get<SeedTool>().isReversed());
    w.leaveTablet(End::Eraser);
    EXPECT_FALSE(w.tools().get<SeedTool>().isReversed());
    peel.setReversed(false);
}

TEST_F(Tablet, OnSlicesTheTipAddsAndTheEraserRemoves) {
    w.trigger("slices");
    auto& slice = w.part("axialSlice");
    StudioWindow::wait("the slices", [&] { return slice.isVisible() && w.studio().isIdle(); });
    w.studio().growth().setAutoStart(false);
    w.studio().hand().take(w.tools().get<PaintTool>());
    w.stroke(slice, {{{0.45, 0.5}, 0.5}, {{0.5, 0.5}, 0.5}, {{0.55, 0.5}, 0.5}});
    EXPECT_TRUE(last<studio::PaintSegment>().isToAdd);
    const auto added = w.studio().host().facts()->growth.voxels;
    EXPECT_GT(added, 0U);
    w.stroke(slice, {{{0.5, 0.5}, 0.5}}, End::Eraser);
    EXPECT_FALSE(last<studio::PaintSegment>().isToAdd);
    EXPECT_LT(w.studio().host().facts()->growth.voxels, added);
    // With the seed tool likewise.
    w.studio().hand().take(w.tools().get<SeedTool>());
    w.stroke(slice, {{{0.5, 0.6}, 0.5}, {{0.55, 0.6}, 0.5}});
    EXPECT_EQ(last<studio::Seed>().trails.size(), 1U);
    const auto seeded = w.studio().host().facts()->growth.voxels;
    w.stroke(slice, {{{0.5, 0.6}, 0.5}, {{0.55, 0.6}, 0.5}}, End::Eraser);
    EXPECT_LT(w.studio().host().facts()->growth.voxels, seeded);
    EXPECT_FALSE(last<studio::PaintSegment>().isToAdd);
    w.leaveTablet(End::Eraser);
    w.settle();
    w.trigger("only3D");
    w.studio().growth().setAutoStart(true);
    w.settle();
}

// For the replay without a window, which the script that runs this makes and compares.
TEST_F(Tablet, ASessionDrawnWithThePenIsSaved) {
    w.studio().hand().take(w.tools().get<DrillTool>());
    w.drawMask(0.05);
    w.stroke(w.view(), {{{0.45, 0.48}, 0.3}, {{0.5, 0.5}, 0.6}, {{0.56, 0.53}, 0.95}});
    w.settle();
    w.studio().hand().take(w.tools().get<LaserTool>());
    w.drawMask(0.03);
    w.stroke(w.view(), {{{0.4, 0.4}, 0.5}, {{0.42, 0.45}, 0.7}});
    w.settle();
    w.studio().hand().take(w.tools().get<PeelTool>());
    w.drawMask(0.08);
    w.stroke(w.view(), {{{0.5, 0.5}, 0.5}, {{0.5, 0.53}, 0.7}});
    w.settle();
    w.stroke(w.view(), {{{0.5, 0.5}, 0.5}, {{0.5, 0.51}, 0.7}}, End::Eraser);
    w.leaveTablet(End::Eraser);
    w.studio().growth().setAutoStart(false);
    w.studio().hand().take(w.tools().get<SeedTool>());
    w.stroke(w.view(), {{{0.46, 0.5}, 0.4}, {{0.54, 0.5}, 0.4}});
    w.settle();
    w.studio().growth().setAutoStart(true);
    w.leaveTablet();
    w.rest();
    w.studio().takeScreenshot(StudioWindow::folder / "tablet.png");
    StudioWindow::wait("the screenshot", [] { return exists(StudioWindow::folder / "tablet.png"); });
    ASSERT_TRUE(w.studio().files().saveSession(StudioWindow::folder / "tablet.json"));
}

} // namespace
} // namespace vs::desktop
