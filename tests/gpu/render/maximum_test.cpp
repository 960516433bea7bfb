// SPDX-License-Identifier: Apache-2.0
// Maximum intensity projection by bounds of slabs misses no sample: against marching through everything, and
// against a search of all samples without a device. Noise is the hard case: no part of it hides another.
#include "gpu/gl_test.h"
#include "gpu/render/cpu_rays.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"

#include <random>

namespace vs::render {
namespace {

using field::SculptureView;
using test::CpuRays;
using test::Stage;

constexpr glm::ivec2 kMaximumSize{103, 77}; // no multiple of a square's or a beam's side

// Noise, less of it on one side, in places under a dim fog of one value.
volume::Volume noise(volume::ScalarType type, glm::ivec3 dims, glm::dvec3 spacing) {
    std::mt19937 random(7);
    const auto value = [&](glm::dvec3 p) {
        const double level = double(random() % 256) * (0.3 + 0.7 * p.x / dims.x);
        return p.y < 0.3 * dims.y ? 20.0 : level;
    };
    return phantom::makePhantom(dims, type, value, spacing);
}

// From outside, close by, and from within.
std::vector<Camera> cameras() {
    std::vector<Camera> all;
    for (const auto projection : {Projection::Perspective, Projection::Orthographic}) {
        for (const double zoom : {0.3, 1.0, 3.0, 40.0}) {
            all.push_back({35, 25, zoom, {2, -3}, projection});
        }
        all.push_back({90, 0, 1, {}, projection});
    }
    return all;
}

void expectNoSampleMissed(Stage& stage, const std::string& what) {
    for (const Camera& camera : cameras()) {
        stage.look(camera, kMaximumSize);
        for (const double step : {0.5, 1.3}) {
            stage.frame.sampleStep = step;
            const auto fast = stage.picture(Mode::Mip);
            EXPECT_EQ(image::compare(fast, stage.marchedPicture(Mode::Mip)).max, 0)
                << what << ", zoom " << camera.zoom << ", step " << step;
        }
    }
}

using MaximumTest = test::GlTest;

TEST_F(MaximumTest, NoSampleIsMissed) {
    for (const auto type :
         {volume::ScalarType::UInt8, volume::ScalarType::Int16, volume::ScalarType::Float32}) {
        for (const Range range : {Range{0, 255}, Range{30, 180}}) {
            Stage stage(noise(type, {45, 38, 41}, {1, 1.4, 0.8}), range);
            expectNoSampleMissed(stage, fmt::format("{} up to {}", name(type), range.hi));
        }
    }
}

TEST_F(MaximumTest, NoSampleIsMissedBesideACut) {
    Stage stage(noise(volume::ScalarType::UInt8, {45, 38, 41}, {1, 1.4, 0.8}), {0, 255});
    stage.sculpt([](glm::dvec3 p) { return std::clamp(0.5 + (p.x - 0.6 * p.y - 11.3) / 4, 0.0, 1.0); });
    for (const auto view : {SculptureView::Cut, SculptureView::Probe}) {
        stage.view(view);
        expectNoSampleMissed(stage, view == SculptureView::Cut ? "cut" : "probe");
    }
}

// A beam is many cells wide where a small picture shows a large volume, and its slabs are long.
TEST_F(MaximumTest, NoSampleIsMissedInASmallPicture) {
    Stage stage(noise(volume::ScalarType::UInt8, {180, 150, 160}, {1, 1, 1}), {0, 255});
    for (const double azimuth : {0.0, 37.0, 120.0}) {
        stage.look({azimuth, 20}, {23, 17});
        const auto fast = stage.picture(Mode::Mip);
        EXPECT_EQ(image::compare(fast, stage.marchedPicture(Mode::Mip)).max, 0) << azimuth;
    }
}

TEST_F(MaximumTest, ItIsTheGreatestOfAllSamples) {
    Stage stage(noise(volume::ScalarType::UInt8, {45, 38, 41}, {1, 1.4, 0.8}), {0, 255});
    stage.darken();
    const CpuRays rays(stage.volume);
    const double coarse = 255 * 3 * test::filterError(); // voxels from 0 to 255, three axes
    for (const Camera& camera : cameras()) {
        stage.look(camera, kMaximumSize);
        const auto picture = stage.picture(Mode::Mip);
        for (int y = 0; y < kMaximumSize.y; ++y) {
            for (int x = 0; x < kMaximumSize.x; ++x) {
                const auto ray = rays.through(stage.frame.rays, {x + 0.5, y + 0.5});
                const double greatest = std::max(rays.greatest(ray, 0.5), 0.0);
                // Dithering and rounding; a ray that touches the box may have one sample more or less.
                const bool touches = ray.way.hi - ray.way.lo < 0.6;
                EXPECT_NEAR(picture.pixel(x, y)[0], greatest, touches ? 255 : 1.5 + coarse) << x << ' ' << y;
            }
        }
    }
}

} // namespace
} // namespace vs::render
