// SPDX-License-Identifier: Apache-2.0
// Which frames a film has, and what each shows.
#include "studio/editing/film_plan.h"

#include "property.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vs::studio {
namespace {

SaveMovie filmOf(std::vector<Shot> shots) {
    SaveMovie film;
    film.file = "film.webm";
    film.framesPerSecond = 20;
    film.shots = std::move(shots);
    return film;
}

FilmSubject subject() {
    FilmSubject subject;
    subject.view.range = {10, 200};
    subject.view.camera.azimuthDegrees = 30;
    subject.generation = 40;
    return subject;
}

Shot orbit(Shot::Orbit orbit, double amount, double seconds = 3) {
    Shot shot;
    shot.orbit = orbit;
    shot.amount = amount;
    shot.seconds = seconds;
    return shot;
}

double turned(const FilmPlan& plan, int frame) { return plan.frame(frame).view.camera.azimuthDegrees - 30; }

TEST(FilmPlan, AWholeTurnLoopsByEqualSteps) {
    const FilmPlan plan(filmOf({orbit(Shot::Orbit::Turntable, 360)}), subject());
    ASSERT_EQ(plan.frameCount(), 60);
    for (int frame = 0; frame < 60; ++frame) {
        EXPECT_NEAR(turned(plan, frame), 6.0 * frame, 1e-9);
    }
}

TEST(FilmPlan, PartOfATurnEndsWhereItShould) {
    const FilmPlan plan(filmOf({orbit(Shot::Orbit::Turntable, -90)}), subject());
    EXPECT_NEAR(turned(plan, 0), 0, 1e-9);
    EXPECT_NEAR(turned(plan, plan.frameCount() - 1), -90, 1e-9);
}

TEST(FilmPlan, ShotsFollowOneAnother) {
    Shot growth;
    growth.kind = Shot::Kind::Growth;
    growth.seconds = 2;
    Shot back = growth;
    back.isBackward = true;
    const FilmPlan plan(filmOf({growth, back, orbit(Shot::Orbit::None, 0, 1)}), subject());
    ASSERT_EQ(plan.frameCount(), 100);
    EXPECT_EQ(plan.frame(0).generation, 1);
    EXPECT_EQ(plan.frame(39).generation, 40);
    EXPECT_EQ(plan.frame(40).generation, 40);
    EXPECT_EQ(plan.frame(79).generation, 1);
    EXPECT_FALSE(plan.frame(80).generation);
    EXPECT_EQ(plan.frame(99).view, subject().view);
    EXPECT_EQ(plan.frameAt(1.99), 39);
    EXPECT_EQ(plan.frameAt(1e9), 99);
}

// Each key is shown at its time, and nothing between two keys is beyond them.
TEST(FilmPlan, GoesThroughItsKeys) {
    test::checkProperty(100, [] {
        Shot shot;
        shot.kind = Shot::Kind::Keys;
        shot.seconds = 4;
        const int count = 2 + *test::below(4);
        for (int n = 0; n < count; ++n) {
            FilmKey key;
            key.seconds = 4.0 * n / (count - 1);
            render::Camera camera;
            camera.azimuthDegrees = *test::between(-60, 60);
            camera.zoom = *test::between(0.5, 4);
            key.view.camera = camera;
            key.view.range = Range{*test::between(0, 50), *test::between(60, 90)};
            key.generation = *test::below(40);
            shot.keys.push_back(key);
        }
        SaveMovie film = filmOf({shot});
        film.framesPerSecond = 15.0 * (count - 1) / 4 + 0.25; // a frame at each key
        const FilmPlan plan(film, subject());
        const int frames = plan.frameCount() - 1;
        RC_ASSERT(frames == 15 * (count - 1));
        for (int n = 0; n < count; ++n) {
            const FilmFrame frame = plan.frame(15 * n);
            const FilmKey& key = shot.keys[std::size_t(n)];
            RC_ASSERT(std::abs(frame.view.camera.azimuthDegrees - key.view.camera->azimuthDegrees) < 1e-6);
            RC_ASSERT(std::abs(frame.view.range.lo - key.view.range->lo) < 1e-9);
            RC_ASSERT(frame.generation == key.generation);
        }
        for (int number = 0; number < frames; ++number) {
            const auto& before = shot.keys[std::size_t(number / 15)].view.camera->zoom;
            const auto& after = shot.keys[std::size_t(number / 15 + 1)].view.camera->zoom;
            const double zoom = plan.frame(number).view.camera.zoom;
            RC_ASSERT((zoom >= std::min(before, after) - 1e-9));
            RC_ASSERT((zoom <= std::max(before, after) + 1e-9));
        }
    });
}

// The camera is where a stroke was drawn while it is drawn, the step is done afterwards, and at the end all
// are.
TEST(FilmPlan, PlaysWhatWasDone) {
    Peel peel;
    peel.mask = {Shape::FreeForm, {{400, 300}, {500, 300}, {500, 400}, {400, 400}}};
    peel.canvas = Canvas{};
    peel.canvas->view = subject().view;
    peel.canvas->view.camera.azimuthDegrees = 90;
    FilmSubject made = subject();
    made.steps = {std::make_shared<const Operation>(peel), std::make_shared<const Operation>(Grow{5})};
    Shot shot;
    shot.kind = Shot::Kind::Session;
    shot.seconds = 6;
    const FilmPlan plan(filmOf({shot}), made);
    std::size_t steps = 0;
    int drawn = 0;
    for (int number = 0; number < plan.frameCount(); ++number) {
        const FilmFrame frame = plan.frame(number);
        ASSERT_TRUE(frame.steps);
        EXPECT_GE(*frame.steps, steps) << "nothing is taken back";
        steps = *frame.steps;
        if (!frame.strokes.isEmpty()) {
            ++drawn;
            EXPECT_EQ(frame.view.camera, peel.canvas->view.camera);
            EXPECT_EQ(steps, 0U);
        }
    }
    EXPECT_GT(drawn, 10);
    EXPECT_EQ(steps, 2U);
    EXPECT_EQ(plan.frame(plan.frameCount() - 1).view, made.view);
}

} // namespace
} // namespace vs::studio
