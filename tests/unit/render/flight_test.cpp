// SPDX-License-Identifier: Apache-2.0
#include "render/camera/flight.h"
#include "render/camera/orbit.h"

#include "base/error.h"
#include "property.h"

#include <array>
#include <cmath>
#include <vector>

namespace vs::render {
namespace {

double drawn(double lo, double hi) { return *test::between(lo, hi); }

// A camera as it is given in a file: any angles, also beyond half a turn.
Camera givenCamera() {
    Camera camera{drawn(-720, 720), drawn(-90, 90), std::exp(drawn(-3, 3)), {drawn(-50, 50), drawn(-50, 50)}};
    camera.projection = *test::coin() ? Projection::Perspective : Projection::Orthographic;
    camera.rollDegrees = drawn(-180, 180);
    return camera;
}

Flight anyFlight() {
    Flight flight{{}, *test::coin() ? Ends::Rest : Ends::Run};
    const int count = 1 + *test::below(6);
    double time = drawn(-2, 2);
    for (int n = 0; n < count; ++n, time += drawn(0.1, 3)) {
        flight.keys.push_back({time, givenCamera(), {*test::below(3) - 1, 0, 0}});
    }
    return flight;
}

std::array<double, 3> anglesIn(const Camera& camera) {
    return {camera.azimuthDegrees, camera.elevationDegrees, camera.rollDegrees};
}

std::string refusalOf(const Flight& flight) {
    try {
        flightFrames(flight, 25);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Flight, PassesThroughItsKeys) {
    test::checkProperty(500, [] {
        const Flight flight = anyFlight();
        for (const CameraKey& key : flight.keys) {
            const Camera camera = cameraAt(flight, key.seconds);
            RC_ASSERT(camera.zoom == key.camera.zoom);
            RC_ASSERT(camera.panMm == key.camera.panMm);
            RC_ASSERT(camera.projection == key.camera.projection);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double off = anglesIn(camera)[axis] - anglesIn(key.camera)[axis];
                RC_ASSERT(std::abs(std::remainder(off, 360)) < 1e-10); // whole turns round what they add
            }
        }
        RC_ASSERT(cameraAt(flight, flight.keys.front().seconds) == flight.keys.front().camera);
    });
}

TEST(Flight, NothingOvershoots) {
    test::checkProperty(300, [] {
        const Flight flight = anyFlight();
        for (std::size_t n = 1; n < flight.keys.size(); ++n) {
            const CameraKey& from = flight.keys[n - 1];
            const CameraKey& to = flight.keys[n];
            const auto [least, most] = std::minmax(from.camera.zoom, to.camera.zoom);
            for (int part = 0; part <= 20; ++part) {
                const double seconds = from.seconds + (to.seconds - from.seconds) * part / 20;
                const Camera camera = cameraAt(flight, seconds);
                RC_ASSERT(camera.zoom >= least * (1 - 1e-14));
                RC_ASSERT(camera.zoom <= most * (1 + 1e-14));
            }
        }
    });
}

TEST(Flight, TurnsTheShorterWayAndWholeTurnsWhereAsked) {
    test::checkProperty(300, [] {
        const Flight flight = anyFlight();
        for (std::size_t n = 1; n < flight.keys.size(); ++n) {
            const Camera from = cameraAt(flight, flight.keys[n - 1].seconds);
            const Camera to = cameraAt(flight, flight.keys[n].seconds);
            const double asked = 360.0 * flight.keys[n].wholeTurns.x;
            RC_ASSERT(std::abs(to.azimuthDegrees - from.azimuthDegrees - asked) <= 180 + 1e-6);
            RC_ASSERT(std::abs(to.elevationDegrees - from.elevationDegrees) <= 180 + 1e-6);
            RC_ASSERT(std::abs(to.rollDegrees - from.rollDegrees) <= 180 + 1e-6);
        }
    });
}

TEST(Flight, AcrossTheBackItDoesNotGoAroundTheFront) {
    const Flight flight{{{0, Camera{170, 0}}, {1, Camera{-170, 0}}}};
    EXPECT_NEAR(cameraAt(flight, 0.5).azimuthDegrees, 180, 1e-12);
    EXPECT_NEAR(cameraAt(flight, 1).azimuthDegrees, 190, 1e-12);
}

TEST(Flight, RestsWhereTwoKeysAreEqual) {
    test::checkProperty(200, [] {
        const Camera rest = givenCamera();
        const Flight flight{{{0, givenCamera()}, {1, rest}, {2, rest}, {4, givenCamera()}}, Ends::Run};
        const Camera there = cameraAt(flight, 1);
        for (double seconds = 1; seconds < 2; seconds += 0.1) {
            Camera seen = cameraAt(flight, seconds);
            RC_ASSERT(seen == there);
        }
    });
}

// The patient's axis is upright in the picture when the viewer's direction to the right is level.
TEST(Flight, NothingRollsUnlessAKeyDoes) {
    test::checkProperty(300, [] {
        Flight flight = anyFlight();
        for (CameraKey& key : flight.keys) {
            key.camera.rollDegrees = 0;
        }
        const double seconds = flight.keys.front().seconds + durationSeconds(flight) * drawn(0, 1);
        RC_ASSERT(std::abs(viewerAxes(cameraAt(flight, seconds))[0].z) < 1e-12);
    });
}

TEST(Flight, AFullTurnHasEqualStepsAndLoops) {
    test::checkProperty(100, [] {
        const Camera camera = givenCamera();
        const int turns = *test::below(2) == 0 ? 1 : -2;
        const int count = 2 + *test::below(200);
        const auto frames = flightFrames(turntable(camera, 360 * turns, count / 25.0), 25);
        RC_ASSERT(int(frames.size()) == count);
        RC_ASSERT(frames.front() == camera);
        const double step = 360.0 * turns / count;
        for (int n = 0; n < count; ++n) {
            RC_ASSERT(std::abs(frames[std::size_t(n)].azimuthDegrees - camera.azimuthDegrees - n * step) <
                      1e-9);
            RC_ASSERT(frames[std::size_t(n)].elevationDegrees == camera.elevationDegrees);
        }
    });
}

// Half turns are the ones whose shorter way is not known.
TEST(Flight, TurntablesTurnAsFarAsTheyAreToldTo) {
    for (const double degrees : {-900.0, -360.0, -180.0, -90.0, 30.0, 180.0, 360.0, 400.0, 540.0}) {
        for (const double azimuth : {0.0, 0.1, 33.3, -170.0, 1e3 / 7}) {
            const auto frames = flightFrames(turntable(Camera{azimuth, 10}, degrees, 4), 100);
            const double end = std::remainder(degrees, 360) == 0 ? degrees - degrees / 400 : degrees;
            EXPECT_NEAR(frames.back().azimuthDegrees - azimuth, end, 1e-9) << degrees << " from " << azimuth;
            const auto tilted = flightFrames(tiltOver(Camera{10, azimuth}, degrees, 4), 100);
            EXPECT_NEAR(tilted.back().elevationDegrees - azimuth, end, 1e-9)
                << degrees << " from " << azimuth;
        }
    }
}

TEST(Flight, RockingSwingsEvenlyToBothSides) {
    const Camera camera{20, 5};
    const Flight flight = rocking(camera, 15, 8);
    const auto swing = [&](double seconds) { return cameraAt(flight, seconds).azimuthDegrees - 20; };
    EXPECT_EQ(cameraAt(flight, 0), camera);
    EXPECT_DOUBLE_EQ(swing(2), 15);
    EXPECT_DOUBLE_EQ(swing(6), -15);
    for (double seconds = 0; seconds <= 4; seconds += 0.05) {
        EXPECT_NEAR(swing(seconds), 15 * std::sin(seconds / 8 * 2 * 3.14159265358979), 0.03) << "a pendulum";
        EXPECT_NEAR(swing(seconds), -swing(seconds + 4), 1e-9) << "one side as the other";
    }
    EXPECT_NEAR((swing(1e-4) - swing(0)) / 1e-4, (swing(8) - swing(8 - 1e-4)) / 1e-4, 1e-2) << "the seam";
}

TEST(Flight, ASpiralTurnsWhileItRises) {
    const Flight flight = spiral(Camera{10, -20}, 360, 60, 5);
    EXPECT_EQ(cameraAt(flight, 0), (Camera{10, -20}));
    const Camera half = cameraAt(flight, 2.5);
    EXPECT_NEAR(half.azimuthDegrees, 190, 1e-9);
    EXPECT_NEAR(half.elevationDegrees, 20, 1e-9);
    EXPECT_NEAR(cameraAt(flight, 5).azimuthDegrees, 370, 1e-9);
    EXPECT_EQ(cameraAt(flight, 5).elevationDegrees, 60);
}

TEST(Flight, ZoomGoesByRatios) {
    const Flight flight = zoomIn(Camera{.zoom = 2}, 9, 2);
    EXPECT_EQ(cameraAt(flight, 0).zoom, 2);
    EXPECT_NEAR(cameraAt(flight, 1).zoom, 6, 1e-12) << "half of the way is the root of the factor";
    EXPECT_EQ(cameraAt(flight, 2).zoom, 18);
}

TEST(Flight, AFilmShowsBothEndsAndLastsAsLongAsTheFlight) {
    const Flight flight{{{3, Camera{0, 0}}, {5, Camera{90, 0}}}};
    const auto frames = flightFrames(flight, 25);
    EXPECT_EQ(frames.size(), 50U);
    EXPECT_EQ(frames.front().azimuthDegrees, 0);
    EXPECT_EQ(frames.back().azimuthDegrees, 90);
    EXPECT_EQ(flightFrames({{{0, Camera{7, 0}}}}, 25), std::vector<Camera>{(Camera{7, 0})});
}

TEST(Flight, WhatIsNoFlightIsRefusedInOneLine) {
    EXPECT_NE(refusalOf({}).find("without key frames"), std::string::npos);
    EXPECT_NE(refusalOf({{{0, {}}, {2, {}}, {2, {}}}}).find("key frame 3 at 2 s"), std::string::npos);
    EXPECT_NE(refusalOf({{{0, {}}, {2, Camera{90, 0}}}, Ends::Loop}).find("loop"), std::string::npos);
    EXPECT_EQ(refusalOf({{{0, {}}, {2, Camera{720, 0}}}, Ends::Loop}), "");
    EXPECT_THROW(flightFrames(turntable({}, 360, 1), 0), Error);
}

} // namespace
} // namespace vs::render
