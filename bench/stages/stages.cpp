// SPDX-License-Identifier: Apache-2.0
#include "stages.h"

#include "field/cell_ranges.h"
#include "field/gradient.h"
#include "gpu/sculpt/surface_makers.h"
#include "phantom/phantom.h"
#include "render/colours/classification.h"
#include "render/rays/occlusion.h"
#include "sculpt/surface/tool_cut.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace vs {

namespace {

// A ball of radius 50 in a cube of 128, and what its occlusion is made from.
struct LitBall {
    LitBall()
        : field(field::uploadVolume(phantom::makePhantom(
              glm::ivec3(128), volume::ScalarType::UInt8,
              [](glm::dvec3 p) {
                  return std::clamp(100 + 40 * (50 - glm::distance(p, glm::dvec3(64))), 0.0, 200.0);
              }))),
          cells(field::computeCellRanges(field)) {
        input.scene.data = &field;
        input.scene.displayedRange = {100, 255};
        input.macrocells = &macrocells;
        macrocells.rebuild({.dataCells = &cells.cells, .visibleRange = input.scene.displayedRange});
        occlusion.rebuild(input);
    }

    field::Field field;
    field::CellRanges cells;
    render::Macrocells macrocells;
    render::OcclusionVolume::Input input;
    render::OcclusionVolume occlusion;
};

// A function that is another one each time.
struct ChangingFunction {
    ChangingFunction()
        : field(field::uploadVolume(phantom::makePhantom({17, 16, 16}, volume::ScalarType::Int16,
                                                         [](glm::dvec3 p) { return -1000 + 250 * p.x; }))) {
        for (int i = 0; i < 6; ++i) {
            const int shade = 40 * i;
            function.points.push_back(
                {-900.0 + 600 * i, i % 3 == 0 ? 0.4 : 0, render::Colour(shade, 255 - shade, 90)});
        }
    }
    void change() {
        function.points[0].opacity = std::fmod(function.points[0].opacity + 0.1, 1.0);
        classification.update(function, field);
    }

    field::Field field;
    render::TransferFunction function;
    render::Classification classification;
};

// A stroke's stamp on a sculpture, the same one each time.
class Stamp {
public:
    Stamp(glm::ivec3 dims, sculpt::MaskRaster mask, std::vector<field::SurfacePoint> surface,
          sculpt::ToolCut cut)
        : sculpture_(dims), cutter_(volume::makeGeometry(dims)), mask_(std::move(mask)),
          surface_(std::move(surface)), cut_(cut) {}

    void cut() { cutter_.cut(sculpture_, std::span(std::as_const(surface_)), mask_, cut_, nullptr); }

private:
    sculpt::Sculpture sculpture_;
    sculpt::ToolCutter cutter_;
    sculpt::MaskRaster mask_;
    std::vector<field::SurfacePoint> surface_;
    sculpt::ToolCut cut_;
};

BenchStage drilling(const std::string& name, glm::ivec3 dims, glm::dvec2 centre, double radius, double height,
                    double depth) {
    sculpt::ToolCut cut;
    cut.sweep.directionWorld = glm::dvec3(0, 0, 1);
    cut.sweep.depthSteps = depth;
    const auto mask = sculpt::rasterize(sculpt::circleOutline(centre, radius), 0.5);
    const auto stamp = std::make_shared<Stamp>(dims, mask, test::slabUnder(mask, height), cut);
    return {name, [stamp] { stamp->cut(); }};
}

BenchStage peeling() {
    sculpt::ToolCut cut;
    cut.sweep.direction = sculpt::ToolDirection::OwnNormal;
    cut.sweep.depthSteps = 1;
    const auto mask = sculpt::rasterize(sculpt::circleOutline({128, 128}, 74), 0.5);
    const auto stamp = std::make_shared<Stamp>(glm::ivec3(256, 256, 128), mask,
                                               test::sphereUnder(mask, {128, 128, 130}, 120), cut);
    return {"peel a layer, 300 x 300 elements", [stamp] { stamp->cut(); }};
}

} // namespace

std::vector<BenchStage> countingStages() {
    std::mt19937 random(3);
    const auto field = std::make_shared<field::Field>(field::uploadVolume(
        phantom::makePhantom(glm::ivec3(256), volume::ScalarType::Int16, [&](glm::dvec3 p) {
            const double noise = double(random() % 64);
            return (glm::distance(p, glm::dvec3(128)) < 90 ? 1000 : 20) + noise;
        })));
    const Range gradients = field::gradientRange(*field);
    return {{"range of gradients, 256^3", [field] { field::gradientRange(*field); }},
            {"histogram of gradients, 256^3",
             [field, gradients] { field::gradientHistogram(*field, gradients); }},
            {"joint histogram, 256^3", [field, gradients] { field::jointHistogram(*field, gradients); }}};
}

std::vector<BenchStage> lookingStages() {
    const auto function = std::make_shared<ChangingFunction>();
    const auto ball = std::make_shared<LitBall>();
    return {{"change of a transfer function", [function] { function->change(); }},
            {"occlusion, 128^3", [ball] { ball->occlusion.rebuild(ball->input); }},
            {"occlusion after a cut of 20^3", [ball] {
                 ball->occlusion.update(ball->input, {{40, 40, 100}, {60, 60, 120}});
             }}};
}

std::vector<BenchStage> sculptingStages() {
    return {drilling("drill, depth 10, 100 x 100 elements", {160, 160, 96}, {80, 80}, 24, 30, 10),
            drilling("drill far beyond the volume", glm::ivec3(48), {23.5, 23.5}, 12, 4, 4000),
            peeling(),
            {"raster of a mask, 390 x 380 elements", [] {
                 sculpt::rasterize(sculpt::ellipseOutline({200, 200}, {195, 190}), 1);
             }}};
}

} // namespace vs
