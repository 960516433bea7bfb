// SPDX-License-Identifier: Apache-2.0
// Skipping what cannot be seen changes no picture: every mode, transfer function, sculpture, segmentation and
// projection, against marching through everything.
#include "gpu/gl_test.h"
#include "gpu/render/stage.h"
#include "image/compare.h"
#include "phantom/phantom.h"
#include "test_data.h"
#include "volume/reading/read_volume.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace vs::render {
namespace {

using field::SculptureView;
using test::Stage;

constexpr glm::ivec2 kSize{96, 80};

// Positions are parts of the values' range, so that the same functions suit every volume.
TransferFunction functionOf(FunctionKind kind, double lighting) {
    TransferFunction f;
    f.kind = kind;
    f.lighting.amount = lighting;
    f.positions = Positions::Relative;
    if (kind == FunctionKind::TwoD) {
        f.shapes = {{Trapezoid{{0.3, 0.6}, {0.35, 0.55}, {0.05, 0.9}, {0.5, 0.5}}, {220, 90, 40}, 0.3},
                    {Trapezoid{{0.6, 1.0}, {0.7, 1.0}, {0, 1}, {0.5, 0.5}}, {240, 230, 200}, 0.6}};
    } else {
        f.points = {{0.3, 0, {180, 60, 40}},
                    {0.42, 0.15, {220, 110, 60}},
                    {0.5, 0, {250, 180, 120}},
                    {0.65, 0, {240, 230, 200}},
                    {0.9, 0.5, {255, 255, 255}}};
    }
    return f;
}

struct Scenario {
    std::optional<FunctionKind> function;
    std::optional<SculptureView> sculpture; // nothing: uncut
    bool hasSegmentation = false;
    Projection projection = Projection::Perspective;

    [[nodiscard]] std::string name() const {
        constexpr const char* functions[] = {"intensity", "gradient", "two-dimensional"};
        return fmt::format("{} function, {}, {} segmentation, {}",
                           function ? functions[int(*function)] : "no",
                           !sculpture                           ? "uncut"
                           : *sculpture == SculptureView::Probe ? "probe"
                                                                : "cut",
                           hasSegmentation ? "a" : "no",
                           projection == Projection::Perspective ? "perspective" : "orthographic");
    }
};

std::vector<Scenario> scenariosOf(Mode mode) {
    std::vector<Scenario> scenarios;
    for (const auto& function : {std::optional<FunctionKind>(), std::optional(FunctionKind::Intensity),
                                 std::optional(FunctionKind::Gradient), std::optional(FunctionKind::TwoD)}) {
        for (const auto& sculpture : {std::optional<SculptureView>(), std::optional(SculptureView::Cut),
                                      std::optional(SculptureView::Probe)}) {
            for (const bool hasSegmentation : {false, true}) {
                for (const auto projection : {Projection::Perspective, Projection::Orthographic}) {
                    if (function || mode != Mode::Volume) {
                        scenarios.push_back({function, sculpture, hasSegmentation, projection});
                    }
                }
            }
        }
    }
    return scenarios;
}

// A stage with an oblique cut with a round notch and a segmented ball, to be shown or not.
struct MatrixStage : Stage {
    MatrixStage(volume::Volume v, Range range) : Stage(std::move(v), range) {
        const glm::dvec3 size(volume.geometry.dims);
        sculpt([size](glm::dvec3 p) {
            const double plane = glm::dot(p / size - glm::dvec3(0.55, 0.4, 0.5), glm::dvec3(0.8, -0.5, 0.3));
            const double notch = 0.25 - glm::length(p / size - glm::dvec3(0.4, 0.1, 0.6));
            return std::clamp(0.5 + std::max(plane, notch) * size.x / 3, 0.0, 1.0);
        });
        segment([size](glm::dvec3 p) {
            const double inside = 0.22 - glm::length(p / size - glm::dvec3(0.45, 0.45, 0.4));
            return std::clamp(0.5 + inside * size.x / 2, 0.0, 1.0);
        });
    }

    void arrange(const Scenario& scenario, double lighting) {
        frame.classification = nullptr;
        if (scenario.function) {
            classification.update(functionOf(*scenario.function, lighting), field);
            frame.classification = &classification;
        }
        frame.scene.sculpture = scenario.sculpture ? &sculpture : nullptr;
        frame.scene.view = scenario.sculpture.value_or(SculptureView::Cut);
        frame.scene.segmentation = scenario.hasSegmentation ? &segmentation : nullptr;
        look({35, 25, 1.1, {}, scenario.projection}, kSize);
    }
};

// Part of the pixels of which some channel differs by more than two.
double partApart(const image::Image& a, const image::Image& b) {
    const int count = a.width * a.height;
    int apart = 0;
    for (int i = 0; i < count; ++i) {
        const auto* p = a.pixel(i % a.width, i / a.width);
        const auto* q = b.pixel(i % a.width, i / a.width);
        apart += std::abs(p[0] - q[0]) > 2 || std::abs(p[1] - q[1]) > 2 || std::abs(p[2] - q[2]) > 2 ? 1 : 0;
    }
    return double(apart) / count;
}

bool isOfOneColour(const image::Image& picture) {
    image::Image plain(picture.width, picture.height);
    for (std::size_t i = 0; i < plain.rgba.size(); ++i) {
        plain.rgba[i] = picture.rgba[i % 4];
    }
    return image::compare(picture, plain).changedFraction < 0.05;
}

// Samples lie on the same places however a ray came there, so that only what rounding does to them, and to a
// ray that touches a surface, may differ; and, in volume mode, how far a ray goes on behind what is almost
// opaque. Dithering makes single grey levels of that, here and there.
void expectSkippingChangesNothing(MatrixStage& stage, Mode mode) {
    for (const Scenario& scenario : scenariosOf(mode)) {
        stage.arrange(scenario, mode == Mode::Volume ? 0 : 1);
        const auto skipping = stage.picture(mode);
        const auto marching = stage.marchedPicture(mode);
        const std::string what = fmt::format("{}, {}", name(mode), scenario.name());
        EXPECT_FALSE(isOfOneColour(marching)) << what;
        EXPECT_LT(image::compare(skipping, marching).mean, 0.05) << what << ": grey levels";
        EXPECT_LT(partApart(skipping, marching), 0.001) << what << ": of the pixels";
    }
}

class SkippingMatrixTest : public test::GlTest, public testing::WithParamInterface<Mode> {};

volume::Volume ballsInAHaze() {
    const auto value = [](glm::dvec3 p) {
        const glm::dvec3 c = glm::mod(p, glm::dvec3(17.0)) - 8.0;
        return std::clamp(4.5 - glm::length(c), 0.0, 2.0) * (50 + p.z) + 0.5 * p.x;
    };
    return phantom::makePhantom({48, 40, 44}, volume::ScalarType::UInt8, value, {1, 1.3, 0.8});
}

TEST_P(SkippingMatrixTest, BallsInAHazeLookTheSame) {
    MatrixStage stage(ballsInAHaze(), {60, 200});
    expectSkippingChangesNothing(stage, GetParam());
}

TEST_P(SkippingMatrixTest, ScansLookTheSame) {
    const auto folder = test::dataFolder();
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "no test data in " << folder;
    }
    for (const char* file : {"tooth.nrrd", "ct_torso_3mm.nii.gz"}) {
        auto volume = volume::readVolume(folder / file).volume;
        const Range upper{volume.range.lo + 0.4 * volume.range.width(), volume.range.hi};
        MatrixStage stage(std::move(volume), upper);
        SCOPED_TRACE(file);
        expectSkippingChangesNothing(stage, GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, SkippingMatrixTest, testing::ValuesIn(kModes),
                         [](const auto& mode) { return name(mode.param); });

using LitSkippingTest = test::GlTest;

// The light is looked at for several pieces of a ray together; which ones must not depend on what was
// skipped.
TEST_F(LitSkippingTest, LitVolumesLookTheSame) {
    MatrixStage stage(ballsInAHaze(), {60, 200});
    for (const Scenario& scenario : scenariosOf(Mode::Volume)) {
        stage.arrange(scenario, 1);
        const auto skipping = stage.picture(Mode::Volume);
        const auto difference = image::compare(skipping, stage.marchedPicture(Mode::Volume));
        EXPECT_LT(difference.mean, 0.05) << scenario.name();
        EXPECT_LT(difference.changedFraction, 0.001) << scenario.name();
    }
}

} // namespace
} // namespace vs::render
