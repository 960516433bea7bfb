// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl_test.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"

#include <cmath>

namespace vs::render {
namespace {

using RayCasterTest = test::GlTest;
using test::allPixels;
using test::Stage;

TEST_F(RayCasterTest, ASphereIsFoundWhereItIs) {
    const glm::dvec3 centre{31.3, 29.7, 33.1};
    const double radius = 20;
    // In voxels of 1 mm the sphere is where the ramp crosses 100; 8 voxels wide, so that trilinear
    // interpolation of it is exact to a few hundredths.
    Stage stage(phantom::makeBall({64, 64, 64}, centre, radius, 200, 0, 8, volume::ScalarType::UInt16),
                {100, 200});
    stage.look({25, 15}, {200, 160});
    const auto pixels = allPixels({200, 160}, 3);
    const auto points = stage.picker.pickPoints(stage.frame, pixels);
    int hits = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto ray = stage.frame.rays.through(pixels[i]);
        const glm::dvec3 toCentre = centre - ray.origin;
        const double along = glm::dot(toCentre, ray.direction);
        const double miss = glm::length(toCentre - along * ray.direction);
        if (points[i].voxel.w < 0.5F) {
            EXPECT_GT(miss, radius - 0.05) << "a ray through the sphere must hit it";
            continue;
        }
        ++hits;
        EXPECT_LT(miss, radius + 0.05) << "a ray beside the sphere must miss it";
        EXPECT_NEAR(glm::length(glm::dvec3(points[i].voxel) - centre), radius, 0.05);
        if (miss < 0.9 * radius) {
            const glm::dvec3 expected = glm::normalize(glm::dvec3(points[i].voxel) - centre);
            EXPECT_GT(glm::dot(expected, glm::dvec3(points[i].normal)), 0.995) << "normals face the viewer";
            const double depth = along - std::sqrt(radius * radius - miss * miss);
            EXPECT_NEAR(points[i].normal.w, depth, 0.15) << "distance from the eye in mm";
        }
    }
    EXPECT_GT(hits, 200);
}

// A ray that grazes a coarse surface may meet a gradient that points a little away from it. Turned round,
// such a normal points into the object: a black speck on its outline.
TEST_F(RayCasterTest, NormalsOnOutlinesPointOutOfTheObject) {
    const glm::dvec3 centre{12.3, 11.7, 12.1};
    for (const Range shown : {Range{100, 255}, Range{-1, 100}}) { // above 100 it is inside, below it outside
        const bool isHollow = shown.lo < 0;
        Stage stage(phantom::makeBall({24, 24, 24}, centre, 7.3, isHollow ? 0 : 200, isHollow ? 200 : 0, 1),
                    shown);
        stage.look({35, 25, 1.5}, {300, 240});
        int hits = 0;
        for (const auto& point : stage.picker.pickPoints(stage.frame, allPixels({300, 240}, 1))) {
            const glm::dvec3 fromCentre = glm::dvec3(point.voxel) - centre;
            if (point.voxel.w < 0.5F || glm::length(fromCentre) > 9) {
                continue;
            }
            const double along = glm::dot(glm::normalize(fromCentre), glm::dvec3(point.normal));
            EXPECT_GT(along, 0.3) << fromCentre.x << ' ' << fromCentre.y << ' ' << fromCentre.z;
            ++hits;
        }
        EXPECT_GT(hits, 1000);
    }
}

TEST_F(RayCasterTest, SkippingChangesNoPicture) {
    Stage stage(phantom::makePhantom({70, 50, 60}, volume::ScalarType::UInt8,
                                     [](glm::dvec3 p) {
                                         const glm::dvec3 c = glm::mod(p, glm::dvec3(23.0)) - 11.0;
                                         return glm::length(c) < 4 ? 60 + 2 * p.z : 0.3 * p.x;
                                     },
                                     {1, 1.3, 0.8}),
                {60, 200});
    for (const bool cut : {false, true}) {
        if (cut) {
            stage.cutAbove(30);
        }
        for (const Mode mode : {Mode::Surface, Mode::Mip, Mode::XRay}) {
            stage.look({40, 30, 1.2}, {160, 120});
            const auto skipping = stage.picture(mode);
            const auto marching = stage.marchedPicture(mode);
            const auto difference = image::compare(skipping, marching);
            // Samples fall elsewhere after a skip: grazing hits and sampled maxima may differ a little.
            EXPECT_LT(difference.mean, 0.35) << name(mode) << " cut " << cut;
            EXPECT_LT(difference.changedFraction, 0.02) << name(mode) << " cut " << cut;
        }
    }
}

TEST_F(RayCasterTest, ACutFaceLiesOnTheSculpturesHalfLevel) {
    Stage stage(phantom::makeBall({64, 64, 64}, {31.5, 31.5, 31.5}, 25, 200, 0, 4), {100, 200});
    stage.cutAbove(35.25);
    stage.look({90, 0}, {200, 160}); // from the patient's left, on to the cut
    const auto pixels = allPixels({200, 160}, 4);
    const auto points = stage.picker.pickPoints(stage.frame, pixels);
    int onFace = 0;
    for (const auto& point : points) {
        if (point.voxel.w > 0.5F && point.normal.x > 0.99F) {
            EXPECT_NEAR(point.voxel.x, 35.25, 0.02);
            ++onFace;
        } else if (point.voxel.w > 0.5F) {
            EXPECT_LT(point.voxel.x, 35.3);
        }
    }
    EXPECT_GT(onFace, 100);
    // The probe view shows the other side: its face looks the other way.
    stage.frame.scene.view = field::SculptureView::Probe;
    stage.rebuild();
    stage.look({-90, 0}, {200, 160});
    for (const auto& point : stage.picker.pickPoints(stage.frame, pixels)) {
        if (point.voxel.w > 0.5F) {
            EXPECT_GT(point.voxel.x, 35.2);
        }
    }
}

TEST_F(RayCasterTest, AnXRayOfABoxIsItsPathLength) {
    // Full value inside the grid, so a ray's brightness is its length in the box over the diagonal.
    Stage stage(
        phantom::makePhantom({40, 40, 40}, volume::ScalarType::UInt8, [](glm::dvec3) { return 200.0; }),
        {0, 200});
    stage.frame.scene.data = &stage.field;
    stage.frame.xrayGain = 1;
    Camera camera;
    camera.projection = Projection::Orthographic;
    stage.look(camera, {100, 100});
    const auto picture = stage.picture(Mode::XRay);
    // Straight through: 40 of sqrt(3) * 40 mm; blended over the background behind it.
    const auto* centre = picture.pixel(50, 50);
    Stage empty(phantom::makePhantom({40, 40, 40}, volume::ScalarType::UInt8,
                                     [](glm::dvec3 p) { return p.x < 1 && p.y < 1 ? 200.0 : 0; }),
                {100, 200});
    empty.look(camera, {100, 100});
    const double behind = empty.picture(Mode::XRay).pixel(50, 50)[0];
    const double expected = behind + (255 - behind) / std::sqrt(3.0);
    EXPECT_NEAR(centre[0], expected, 0.01 * 255 / std::sqrt(3.0) + 1);
}

TEST_F(RayCasterTest, AVolumeOfOneValueIsSeenInFull) {
    // 0.0 has no neighbours that its size tells: comparisons allow for nothing.
    for (const auto& [value, type] :
         {std::pair(42.0, volume::ScalarType::UInt8), std::pair(42.0, volume::ScalarType::Float32),
          std::pair(0.0, volume::ScalarType::Float32)}) {
        Stage stage(phantom::makePhantom({20, 20, 20}, type, [v = value](glm::dvec3) { return v; }),
                    {value, value});
        stage.look({}, {100, 100});
        const int behind = stage.picture(Mode::Mip).pixel(2, 2)[0];
        EXPECT_GT(stage.picture(Mode::Mip).pixel(50, 50)[0], 250) << value;
        EXPECT_GT(stage.picture(Mode::XRay).pixel(50, 50)[0], behind + 100) << value;
    }
}

TEST_F(RayCasterTest, AThinSliceBesideACutIsNotMissed) {
    // Material from x = 35.0 on, cut away from x = 35.3 on: a slice of 0.3 voxel, thinner than a step.
    const auto slice = [](glm::dvec3 p) { return std::clamp(100 + 40 * (p.x - 35.0), 0.0, 200.0); };
    Stage stage(phantom::makePhantom({64, 48, 48}, volume::ScalarType::UInt8, slice), {100, 255});
    stage.cutAbove(35.3);
    Camera camera;
    camera.azimuthDegrees = 90;
    camera.zoom = 2;
    stage.look(camera, {120, 90});
    int hits = 0;
    const auto points = stage.picker.pickPoints(stage.frame, allPixels({120, 90}, 3));
    for (const auto& point : points) {
        hits += point.voxel.w > 0.5F && std::abs(point.voxel.x - 35.3F) < 0.05F ? 1 : 0;
    }
    EXPECT_EQ(std::size_t(hits), points.size());
}

TEST_F(RayCasterTest, AScanFarFromTheWorldsOriginLooksTheSame) {
    // A microscope's volume, 0.001 mm a voxel, tens of metres from the origin: single precision would be lost
    // there.
    auto ball = phantom::makeBall({48, 48, 48}, {23.5, 23.5, 23.5}, 18);
    for (int axis = 0; axis < 3; ++axis) {
        ball.geometry.worldFromVoxel[axis] *= 0.001;
    }
    auto far = ball;
    far.geometry.worldFromVoxel[3] = glm::dvec4(50000, 50000, 20000, 1);
    Stage here(std::move(ball), {100, 200});
    Stage there(std::move(far), {100, 200});
    here.look({30, 20}, {160, 120});
    there.look({30, 20}, {160, 120});
    EXPECT_LT(image::compare(here.picture(Mode::Surface), there.picture(Mode::Surface)).mean, 0.05);
}

TEST_F(RayCasterTest, PartsInSlicesGiveTheWholePicture) {
    Stage stage(phantom::makeBall({48, 48, 48}, {24, 24, 24}, 15), {100, 200});
    stage.look({}, {500, 400});
    const auto whole = stage.picture(Mode::Surface);
    stage.caster.start(stage.frame);
    int slices = 1;
    while (!stage.caster.renderSome(0)) {
        ++slices;
    }
    EXPECT_GT(slices, 3) << "no more than a few squares of pixels a slice";
    EXPECT_EQ(image::compare(whole, stage.caster.readPicture()).max, 0);
}

TEST_F(RayCasterTest, ASegmentsSurfaceHasItsOwnNormals) {
    // A segmented ball in a haze that rises to the left, whose gradient must not be taken for the ball's.
    Stage stage(
        phantom::makePhantom({48, 48, 48}, volume::ScalarType::UInt8, [](glm::dvec3 p) { return p.x; }),
        {100, 200});
    const glm::dvec3 centre(23.5);
    stage.segment(
        [=](glm::dvec3 p) { return std::clamp(0.5 + (14 - glm::length(p - centre)) / 6, 0.0, 1.0); });
    stage.look({30, 20}, {160, 120});
    for (const Mode mode : {Mode::Overlay, Mode::Segment}) {
        stage.frame.mode = mode;
        stage.rebuild();
        int hits = 0;
        for (const auto& point : stage.points(allPixels({160, 120}, 2))) {
            if (point.voxel.w > 0.5F) {
                const glm::dvec3 expected = glm::normalize(glm::dvec3(point.voxel) - centre);
                EXPECT_GT(glm::dot(expected, glm::dvec3(point.normal)), 0.99) << name(mode);
                ++hits;
            }
        }
        EXPECT_GT(hits, 300) << name(mode);
    }
}

TEST_F(RayCasterTest, NonFiniteVoxelsAreNeverSeen) {
    auto volume = phantom::makePhantom({32, 32, 32}, volume::ScalarType::Float32,
                                       [](glm::dvec3) { return std::nan(""); });
    volume.range = {0, 1};
    Stage stage(std::move(volume), {-1e38, 1e38});
    const auto points = stage.picker.pickPoints(stage.frame, allPixels({200, 160}, 10));
    for (const auto& point : points) {
        EXPECT_EQ(point.voxel.w, 0.0F);
    }
}

TEST_F(RayCasterTest, UnknownModeNamesTheChoices) {
    try {
        modeFromName("xry");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(),
                     "mode 'xry' does not exist; choose surface, mip, xray, overlay, segment or volume");
    }
}

} // namespace
} // namespace vs::render
