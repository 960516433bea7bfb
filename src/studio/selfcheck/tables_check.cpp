// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/checks.h"
#include "studio/selfcheck/made_volumes.h"
#include "studio/selfcheck/queries.h"

#include "render/colours/classification.h"

namespace vs::studio {

namespace {

render::TransferFunction curveOver(render::FunctionKind kind) {
    render::TransferFunction function;
    function.kind = kind;
    function.points = {{500, 0, {10, 20, 30}},
                       {900, 0.1, {200, 20, 30}},
                       {1300, 0, {90, 220, 30}},
                       {1900, 0.9, {0, 20, 230}},
                       {2500, 1, {255, 255, 255}}};
    return function;
}

render::TransferFunction planeOfShapes() {
    render::TransferFunction function;
    function.kind = render::FunctionKind::TwoD;
    function.shapes = {
        {render::Trapezoid{{1000, 2000}, {1300, 1700}, {100, 900}, {1, 1}}, {255, 0, 0}, 0.8},
        {render::Trapezoid{{1500, 3000}, {1500, 3000}, {-200, 600}, {1, 1}}, {0, 90, 255}, 0.4}};
    return function;
}

void checkFunction(Tally& tally, const render::TransferFunction& function, const field::Field& field,
                   double allowed) {
    render::Classification classification;
    classification.update(function, field);
    gl::Defines defines;
    classification.addDefines(defines);
    gl::Program program("studio/shaders/classify_values.comp", defines);
    std::vector<glm::vec4> queries;
    for (const glm::vec4 place : placesIn({4000, 2000, 1}, 2000)) {
        queries.emplace_back(glm::vec2(place), 0, 0);
    }
    classification.bind();
    const auto answers = answersOf(program, queries);
    const render::FunctionSampler sampler(function);
    tally.about(std::string("colours and opacities, ") + namesOf(function.kind)[std::size_t(function.kind)]);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const glm::dvec4 expected = sampler.at(double(queries[i].x), double(queries[i].y));
        const glm::dvec4 found(answers[i]);
        for (int c = 0; c < 3; ++c) { // a colour counts for as much as it is opaque
            tally.compare(found[c] * found.w, expected[c] * expected.w, allowed);
        }
        tally.compare(found.w, expected.w, allowed);
    }
}

} // namespace

void checkTables(Tally& tally) {
    const auto field = field::uploadVolume(makeNoise({17, 16, 16}, volume::ScalarType::Int16, 0, 4000));
    // Half a texel of the table, where the function is steepest, and what an 8-bit filter adds to that.
    checkFunction(tally, curveOver(render::FunctionKind::Intensity), field, 5e-3);
    checkFunction(tally, curveOver(render::FunctionKind::Gradient), field, 5e-3);
    // Soft edges bend between the 512 x 256 places at which the table has them.
    checkFunction(tally, planeOfShapes(), field, 0.012);
}

} // namespace vs::studio
