// SPDX-License-Identifier: Apache-2.0
// Pictures of volumes whose appearance is known: against formulas and against plain sampling on the CPU.
#include "gpu/gl_test.h"
#include "gpu/render/cpu_rays.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"

#include <cmath>
#include <optional>
#include <random>

namespace vs::render {
namespace {

using AnalyticTest = test::GlTest;
using test::allPixels;
using test::Stage;

constexpr Projection kProjections[] = {Projection::Perspective, Projection::Orthographic};

volume::Volume constantVolume(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1)) {
    return phantom::makePhantom(
        dims, volume::ScalarType::UInt8, [](glm::dvec3) { return 200.0; }, spacing);
}

TEST_F(AnalyticTest, ASpheresOutlineAndDepthAreExact) {
    const glm::dvec3 centre{31.3, 29.7, 33.1};
    const double radius = 20;
    for (const auto type : {volume::ScalarType::UInt8, volume::ScalarType::UInt16}) {
        // In voxels of 1 mm. The ramp is wide enough that whole numbers place its middle to 0.02 voxel.
        Stage stage(phantom::makeBall({64, 64, 64}, centre, radius, 200, 0, 8, type), {100, 200});
        for (const Projection projection : kProjections) {
            stage.look({25, 15, 1, {}, projection}, {200, 160});
            const auto pixels = allPixels({200, 160}, 3);
            const auto points = stage.points(pixels);
            int hits = 0;
            double worstDepth = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const auto ray = stage.frame.rays.through(pixels[i]);
                const double along = glm::dot(centre - ray.origin, ray.direction);
                const double miss = glm::length(centre - ray.origin - along * ray.direction);
                if (points[i].voxel.w < 0.5F) {
                    EXPECT_GT(miss, radius - 0.05) << "a ray through the sphere must hit it";
                    continue;
                }
                ++hits;
                EXPECT_LT(miss, radius + 0.05) << "a ray beside the sphere must miss it";
                // Along the ray an error of the radius counts as much more as the sphere is slanted.
                const double half = std::sqrt(std::max(radius * radius - miss * miss, 0.0));
                if (half > 0.3 * radius) {
                    worstDepth = std::max(worstDepth, std::abs(double(points[i].normal.w) - (along - half)) *
                                                          half / radius);
                }
            }
            EXPECT_GT(hits, 200);
            EXPECT_LT(worstDepth, 0.05) << name(type) << ": voxels";
        }
    }
}

TEST_F(AnalyticTest, AnXRayIsTheLengthOfItsWay) {
    struct Case {
        glm::ivec3 dims;
        glm::dvec3 spacing;
        Camera camera;
    };
    for (const Projection projection : kProjections) {
        for (const auto& [dims, spacing, camera] :
             {Case{{40, 40, 40}, glm::dvec3(1), {0, 0, 1, {}, projection}},
              Case{{40, 40, 40}, glm::dvec3(1), {35, 25, 1, {}, projection}},
              Case{{50, 30, 24}, {0.7, 1.2, 2.1}, {-50, 40, 1, {}, projection}}}) {
            Stage stage(constantVolume(dims, spacing), {0, 200});
            stage.darken();
            stage.look(camera, {100, 100});
            stage.frame.xrayGain = 1;
            stage.frame.sampleStep = 0.1;
            const auto picture = stage.picture(Mode::XRay);
            const double diagonal = stage.volume.geometry.diagonalMm();
            double sum = 0;
            double expectedSum = 0;
            for (const glm::vec2 pixel : allPixels({100, 100}, 1)) {
                const double length =
                    test::lengthInBox(stage.frame.rays, pixel, stage.volume.geometry) / diagonal;
                const double shown = picture.pixel(int(pixel.x), int(pixel.y))[0] / 255.0;
                // One sample more or less at the ends, and the dithered 8 bits of the picture.
                EXPECT_NEAR(shown, length, 0.1 * stage.volume.geometry.stepMm() / diagonal + 1.01 / 255)
                    << pixel.x << ' ' << pixel.y;
                sum += shown;
                expectedSum += length;
            }
            EXPECT_GT(expectedSum, 500);
            EXPECT_NEAR(sum / expectedSum, 1, 0.01);
        }
    }
}

// Opacity `a` everywhere, white, unlit: what a ray shows is its opacity.
TransferFunction evenFunction(double a) {
    TransferFunction f;
    f.points = {{0, a, {255, 255, 255}}, {255, a, {255, 255, 255}}};
    f.lighting.amount = 0;
    return f;
}

struct Slab {
    const char* name;
    glm::ivec3 dims;
    glm::dvec3 spacing;
    Camera camera;
    std::optional<double> unitMm;
    std::optional<double> cutAt; // voxel y
};

// Mean opacities of what lies well within the slab's outline: as shown, and as the law has it.
std::pair<double, double> meanOpacities(Stage& stage, const Slab& slab, double a) {
    constexpr glm::ivec2 size{64, 64};
    stage.look(slab.camera, size);
    auto f = evenFunction(a);
    f.unitMm = slab.unitMm;
    stage.classify(f);
    const auto picture = stage.picture(Mode::Volume);
    const double unit = slab.unitMm.value_or(stage.volume.geometry.stepMm());
    glm::dvec2 mean(0);
    int count = 0;
    for (const glm::vec2 pixel : allPixels(size, 1)) {
        const double length =
            test::lengthInBox(stage.frame.rays, pixel, stage.volume.geometry, 1, slab.cutAt);
        if (length < 2 * stage.volume.geometry.stepMm()) {
            continue;
        }
        const double shown = picture.pixel(int(pixel.x), int(pixel.y))[0] / 255.0;
        mean += glm::dvec2(linearFromDisplay(glm::dvec3(shown)).x, opacityOver(a, length / unit));
        ++count;
    }
    EXPECT_GT(count, 400) << slab.name;
    return {mean.x / count, mean.y / count};
}

TEST_F(AnalyticTest, ASlabIsAsOpaqueAsItsThicknessSays) {
    const auto straight = Camera{0, 0, 1.6, {}, Projection::Orthographic};
    const auto oblique = Camera{30, 20, 1.2, {}, Projection::Perspective};
    const glm::dvec3 cubes(1);
    for (const Slab& slab : {Slab{"straight through", {32, 16, 32}, cubes, straight, {}, {}},
                             Slab{"thin", {32, 3, 32}, cubes, straight, {}, {}},
                             Slab{"no multiple of the step", {32, 7, 32}, {1, 1, 0.7}, straight, {}, {}},
                             Slab{"oblique", {32, 16, 32}, cubes, oblique, {}, {}},
                             Slab{"anisotropic, oblique", {40, 9, 20}, {0.8, 1.7, 1.3}, oblique, {}, {}},
                             Slab{"per millimetre", {40, 9, 20}, {0.8, 1.7, 1.3}, oblique, 2.5, {}},
                             Slab{"cut between voxels", {32, 16, 32}, cubes, straight, {}, 8.3},
                             Slab{"cut, oblique", {40, 20, 30}, {0.8, 1.2, 1.1}, oblique, {}, 11.6}}) {
        Stage stage(constantVolume(slab.dims, slab.spacing), {0, 255});
        stage.darken();
        if (slab.cutAt) {
            stage.cutAbove(*slab.cutAt, 1);
        }
        for (const double a : {0.005, 0.02, 0.1, 0.3, 0.6}) {
            const auto [shown, expected] = meanOpacities(stage, slab, a);
            EXPECT_NEAR(shown, expected, 0.005 * expected) << slab.name << ", opacity " << a << " a step";
        }
    }
}

TEST_F(AnalyticTest, AMipIsTheGreatestOfItsSamples) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(0, 1);
    // Floats, so that the device interpolates as the CPU does.
    Stage stage(phantom::makePhantom({22, 19, 25}, volume::ScalarType::Float32,
                                     [&](glm::dvec3) { return value(random); }, {1, 1.4, 0.8}),
                {0, 1});
    stage.darken();
    constexpr glm::ivec2 size{80, 72};
    const double coarse = 255 * 3 * test::filterError(); // voxels from 0 to 1, three axes
    const test::CpuRays cpu(stage.volume);
    for (const Projection projection : kProjections) {
        for (const double azimuth : {0.0, 40.0, 130.0}) {
            stage.look({azimuth, 0.7 * azimuth, 1, {}, projection}, size);
            const auto picture = stage.picture(Mode::Mip);
            double sum = 0;
            int beyond = 0;
            for (const glm::vec2 pixel : allPixels(size, 1)) {
                const double expected = 255 * cpu.greatest(cpu.through(stage.frame.rays, pixel), 0.5);
                const double off =
                    std::abs(picture.pixel(int(pixel.x), int(pixel.y))[0] - std::max(expected, 0.0));
                sum += off;
                beyond += off > 1.05 + coarse ? 1 : 0; // rounding and dithering to 8 bits
            }
            EXPECT_LT(sum / (size.x * size.y), 0.4 + coarse);
            // Rays along an edge of the grid have a single sample, which rounding takes or leaves.
            EXPECT_LE(beyond, size.x * size.y / 500);
        }
    }
}

// Smooth noise from 0 to 200.
volume::Volume smoothNoise(int seed) {
    std::mt19937 random{std::mt19937::result_type(seed)};
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<glm::dvec4> waves;
    for (int i = 0; i < 8; ++i) {
        const auto part = [&] { return 0.5 * number(random); };
        waves.emplace_back(part(), part(), part(), 3 * number(random));
    }
    return phantom::makePhantom({34, 30, 38}, volume::ScalarType::UInt16,
                                [waves](glm::dvec3 p) {
                                    double sum = 0;
                                    for (const glm::dvec4& wave : waves) {
                                        sum += std::sin(glm::dot(glm::dvec3(wave), p) + wave.w);
                                    }
                                    return 20000 * std::clamp(0.5 + sum / 9, 0.0, 1.0);
                                },
                                {1, 1.2, 0.9});
}

std::vector<TransferFunction> functionsOfNoise() {
    TransferFunction curve;
    curve.points = {{9000, 0, {200, 40, 20}},
                    {12000, 0.12, {220, 140, 60}},
                    {14500, 0.05, {60, 140, 220}},
                    {18000, 0.5, {255, 250, 240}}};
    TransferFunction plane;
    plane.kind = FunctionKind::TwoD;
    plane.shapes = {{Trapezoid{{6000, 14000}, {8000, 12000}, {300, 4000}, {1, 1}}, {210, 60, 30}, 0.25},
                    {Trapezoid{{12000, 20000}, {13000, 19000}, {0, 6000}, {1, 1}}, {230, 230, 90}, 0.4}};
    curve.lighting.amount = 0;
    plane.lighting.amount = 0;
    return {curve, plane};
}

TEST_F(AnalyticTest, VolumeModeIsPlainCompositing) {
    constexpr glm::ivec2 size{72, 64};
    for (const auto& function : functionsOfNoise()) {
        const FunctionSampler sampler(function);
        for (const Projection projection : kProjections) {
            Stage stage(smoothNoise(5), {0, 1});
            stage.darken();
            stage.classify(function);
            stage.look({30, 25, 1, {}, projection}, size);
            const auto picture = stage.picture(Mode::Volume);
            const test::CpuRays cpu(stage.volume);
            double sum = 0;
            double most = 0;
            double seen = 0;
            for (const glm::vec2 pixel : allPixels(size, 1)) {
                const auto ray = cpu.through(stage.frame.rays, pixel);
                const auto light =
                    glm::dvec3(cpu.composite(ray, sampler, 0.5, test::startJitter(glm::ivec2(pixel))));
                const glm::dvec3 expected = 255.0 * displayFromLinear(light);
                for (int c = 0; c < 3; ++c) {
                    const double off = std::abs(picture.pixel(int(pixel.x), int(pixel.y))[c] - expected[c]);
                    sum += off / (3 * size.x * size.y);
                    most = std::max(most, off);
                    seen += expected[c] / (3 * size.x * size.y);
                }
            }
            EXPECT_GT(seen, 20);
            EXPECT_LT(sum, 1);
            EXPECT_LT(most, 4);
        }
    }
}

} // namespace
} // namespace vs::render
