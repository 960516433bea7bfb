// SPDX-License-Identifier: Apache-2.0
// Fingers look around, whatever the tool; a palm beside a pen does nothing.
#include "model/document/camera_motion.h"
#include "model/hand/pen_watch.h"
#include "model/slices/slice_controller.h"
#include "mouse.h"
#include "studio/document/document_facts.h"
#include "studio_window.h"
#include "tools/camera_tool.h"
#include "tools/peel_tool.h"
#include "view/slice_canvas.h"

#include <gtest/gtest.h>

#include <QTest>

#include <cmath>

namespace vs::desktop {
namespace {

class Fingers : public testing::Test {
protected:
    void SetUp() override {
        w.open();
        w.studio().hand().take(w.tools().get<PeelTool>()); // that only the pen draws with
        middle = QPoint(w.view().width() / 2, w.view().height() / 2);
    }
    void TearDown() override {
        w.fingers(w.view(), {});
        EXPECT_TRUE(w.studio().host().document()->log().empty() || !w.studio().host().facts()->canUndo())
            << "fingers changed the document";
    }
    const render::Camera& camera() { return w.studio().view().shown().camera; }
    // In the plane that is looked at: what is under a place of the view.
    glm::dvec3 under(QPointF place) {
        const auto rays = w.studio().view().rays();
        const auto ray =
            rays.through(glm::dvec2(place.x(), place.y()) * w.studio().view().devicePerLogical());
        const auto depth = glm::dot(w.studio().host().geometry()->centreWorld() - rays.eye, rays.forward);
        return ray.origin + ray.direction * (depth / glm::dot(ray.direction, rays.forward));
    }

    StudioWindow& w = StudioWindow::instance();
    QPointF middle;
};

// Touches come in whole pixels here; on 300 of them that is 0.2 degrees and half a percent.
TEST_F(Fingers, OneTurnsAsAMouseWithTheCameraDoes) {
    w.studio().hand().take(w.tools().get<CameraTool>());
    for (const bool isTurntable : {false, true}) {
        w.studio().camera().setTurntable(isTurntable);
        const auto before = camera();
        w.fingers(w.view(), {middle});
        w.fingers(w.view(), {middle + QPointF(40, 0)});
        w.fingers(w.view(), {middle + QPointF(40, 20)});
        w.fingers(w.view(), {});
        const auto turned = camera();
        auto view = w.studio().view().shown();
        view.camera = before;
        w.studio().view().showView(view);
        const auto part = [&](QPointF place) {
            return QPointF((place.x() + 0.5) / w.view().width(), (place.y() + 0.5) / w.view().height());
        };
        Mouse(w).drag({part(middle), part(middle + QPointF(40, 0)), part(middle + QPointF(40, 20))});
        EXPECT_NE(turned, before);
        EXPECT_NEAR(camera().azimuthDegrees, turned.azimuthDegrees, 1e-9) << isTurntable;
        EXPECT_NEAR(camera().elevationDegrees, turned.elevationDegrees, 1e-9) << isTurntable;
        EXPECT_NEAR(camera().rollDegrees, turned.rollDegrees, 1e-9) << isTurntable;
        EXPECT_NEAR(camera().zoom, turned.zoom, 1e-9) << isTurntable;
    }
    w.studio().camera().setTurntable(false);
}

TEST_F(Fingers, TwiceAsFarApartIsTwiceAsLarge) {
    const double before = camera().zoom;
    const QPointF place = middle + QPointF(60, -30);
    const auto held = under(place);
    w.fingers(w.view(), {place - QPointF(70, 0), place + QPointF(70, 0)});
    for (const int apart : {85, 100, 120, 140}) {
        w.fingers(w.view(), {place - QPointF(apart, 0), place + QPointF(apart, 0)});
    }
    w.fingers(w.view(), {});
    EXPECT_NEAR(camera().zoom, 2 * before, 1e-9);
    EXPECT_NEAR(glm::distance(under(place), held), 0, 1e-6) << "mm from what was under the fingers' middle";
}

TEST_F(Fingers, ATwistRollsByItsAngle) {
    const QPointF place = middle + QPointF(-50, 40);
    const auto held = under(place);
    const double zoom = camera().zoom;
    const auto across = [&](double degrees) {
        const double a = degrees * 3.14159265358979 / 180;
        const QPointF way = 300 * QPointF(std::cos(a), std::sin(a)); // y down: clockwise
        return std::vector<QPointF>{place - 0.5 * way, place + 0.5 * way};
    };
    w.fingers(w.view(), across(0));
    for (const double degrees : {10.0, 20.0, 30.0}) {
        w.fingers(w.view(), across(degrees));
    }
    w.fingers(w.view(), {});
    EXPECT_NEAR(camera().rollDegrees, 30, 0.2);
    EXPECT_NEAR(camera().zoom / zoom, 1, 0.005);
    // The middle of two rounded places is half a pixel off at most.
    EXPECT_LT(glm::distance(under(place), held), w.studio().view().millimetresPerPixel());
}

TEST_F(Fingers, BothFingersKeepWhatIsUnderThemThroughAnyMotion) {
    const QPointF a0 = middle + QPointF(-80, 10);
    const QPointF b0 = middle + QPointF(90, -20);
    const auto heldA = under(a0);
    const auto heldB = under(b0);
    const QPointF a1 = middle + QPointF(-20, 90);
    const QPointF b1 = middle + QPointF(150, 180);
    w.fingers(w.view(), {a0, b0});
    constexpr int kSteps = 10;
    for (int n = 1; n <= kSteps; ++n) {
        const double t = double(n) / kSteps;
        w.fingers(w.view(), {a0 + t * (a1 - a0), b0 + t * (b1 - b0)});
    }
    w.fingers(w.view(), {});
    // Two fingers say what move, size and angle are, so both places are held, to the rounding of the steps.
    const double pixel = w.studio().view().millimetresPerPixel();
    EXPECT_LT(glm::distance(under(a1), heldA), 1.5 * pixel);
    EXPECT_LT(glm::distance(under(b1), heldB), 1.5 * pixel);
}

TEST_F(Fingers, AFingerThatJoinsOrLeavesMovesNothing) {
    w.fingers(w.view(), {middle});
    w.fingers(w.view(), {middle + QPointF(10, 0)});
    const auto before = camera();
    w.fingers(w.view(), {middle + QPointF(10, 0), middle + QPointF(200, 100)});
    EXPECT_EQ(camera(), before);
    w.fingers(w.view(), {middle + QPointF(10, 0)});
    EXPECT_EQ(camera(), before);
}

TEST_F(Fingers, APalmBesideThePenIsIgnored) {
    const auto before = camera();
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}});
    w.fingers(w.view(), {middle});
    w.fingers(w.view(), {middle + QPointF(50, 50)});
    w.leaveTablet();
    w.fingers(w.view(), {middle + QPointF(90, 50)}); // lies there still
    w.fingers(w.view(), {});
    EXPECT_EQ(camera(), before);
    w.fingers(w.view(), {middle}); // a hand that comes after the pen has left
    w.fingers(w.view(), {middle + QPointF(50, 50)});
    w.fingers(w.view(), {});
    EXPECT_NE(camera(), before);
}

TEST_F(Fingers, TabletsThatNeverSayThatThePenHasLeftCountAsLeftAfterAWhile) {
    const auto before = camera();
    w.pen(QEvent::TabletMove, w.view(), {{0.5, 0.5}});
    QTest::qWait(int(PenWatch::kForgottenMs) + 50);
    w.fingers(w.view(), {middle});
    w.fingers(w.view(), {middle + QPointF(50, 50)});
    w.fingers(w.view(), {});
    EXPECT_NE(camera(), before);
}

TEST_F(Fingers, OnSlicesOneScrollsATapLeadsAndTwoMoveAndZoom) {
    w.trigger("slices");
    auto& slice = w.part<SliceCanvas>("axialSlice");
    auto& slices = w.studio().slices();
    StudioWindow::wait("the slices", [&] { return slice.isVisible() && w.studio().isIdle(); });
    const QPointF place(QPoint(slice.width() / 2, slice.height() / 2));

    const auto crosshair = slices.crosshair();
    w.fingers(slice, {place});
    w.fingers(slice, {place - QPointF(0, 36)});
    w.fingers(slice, {});
    EXPECT_EQ(std::abs(slices.crosshair().z - crosshair.z), 3);
    EXPECT_EQ(glm::ivec2(slices.crosshair()), glm::ivec2(crosshair));

    const QPointF tapped = place + QPointF(30, 20);
    const auto expected = slices.geometry(slice.kind()).voxelAt(slice.placeAt(tapped), crosshair.z);
    w.fingers(slice, {tapped});
    w.fingers(slice, {});
    EXPECT_EQ(glm::ivec2(slices.crosshair()), glm::ivec2(glm::round(expected)));

    const double before = slices.view(slice.kind()).pixelMm;
    const auto held = slice.placeAt(place);
    w.fingers(slice, {place - QPointF(40, 0), place + QPointF(40, 0)});
    w.fingers(slice, {place + QPointF(-60, 20), place + QPointF(60, 20)});
    w.fingers(slice, {place + QPointF(-80, 30), place + QPointF(80, 30)});
    w.fingers(slice, {});
    EXPECT_NEAR(slices.view(slice.kind()).pixelMm, before / 2, 1e-3 * before);
    EXPECT_NEAR(glm::distance(slice.placeAt(place + QPointF(0, 30)), held), 0, 1e-6);
    w.trigger("only3D");
    w.settle();
}

} // namespace
} // namespace vs::desktop
