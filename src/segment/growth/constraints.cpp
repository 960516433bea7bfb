// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/constraints.h"

#include "segment/shaders/bindings.h"

#include <cmath>
#include <limits>

namespace vs::segment {

namespace {

bool includes(const std::optional<Range>& wide, const std::optional<Range>& narrow) {
    return !wide || (narrow && wide->lo <= narrow->lo && wide->hi >= narrow->hi);
}

gl::Defines definesOf(const Constraints& constraints) {
    return gl::switchesOn({{"VS_FENCED", constraints.hasFence()},
                           {"VS_GRADIENT", constraints.gradient.has_value()},
                           {"VS_DIFFERENCE", constraints.difference.has_value()},
                           {"VS_GRADIENT_DIFFERENCE", constraints.gradientDifference.has_value()},
                           {"VS_NEIGHBOURS_26", constraints.connectivity == Connectivity::TwentySix}});
}

// The ends rounded to float; nothing given: all there are.
glm::vec2 ends(const std::optional<Range>& range) {
    constexpr float all = std::numeric_limits<float>::max();
    return range ? glm::vec2(float(range->lo), float(range->hi)) : glm::vec2(-all, all);
}

// Of numbers that are whole steps from `first` on those in the range, bounded by halves of steps: what
// rounding makes of the numbers does not count.
glm::vec2 halvesAround(double first, double step, const Range& range) {
    constexpr double hair = 0.05; // of a step: more than floats are off by where there are steps
    const double lo = std::ceil((range.lo - first) / step - hair) - 0.5;
    const double hi = std::floor((range.hi - first) / step + hair) + 0.5;
    return {float(first + lo * step), float(first + hi * step)};
}

glm::vec2 betweenSteps(const field::Field& field, const Range& range) {
    return halvesAround(double(field.valueOffset), field.step, range);
}

} // namespace

bool includes(const Constraints& wide, const Constraints& narrow) {
    const bool isSameFence =
        !wide.hasFence() || (wide.sculpture == narrow.sculpture && wide.view == narrow.view &&
                             wide.sculptureVersion == narrow.sculptureVersion);
    return isSameFence && includes(std::optional(wide.range), std::optional(narrow.range)) &&
           includes(wide.difference, narrow.difference) && includes(wide.gradient, narrow.gradient) &&
           includes(wide.gradientDifference, narrow.gradientDifference) &&
           (wide.connectivity == Connectivity::TwentySix || narrow.connectivity == Connectivity::Six);
}

glm::vec2 comparableRange(const field::Field& field, const Range& range) {
    double lo = std::max(range.lo, field.range.lo);
    double hi = std::min(range.hi, field.range.hi);
    if (field.isIntegral) {
        lo = std::ceil(lo);
        hi = std::floor(hi);
    }
    if (field.step > 0) {
        return lo <= hi ? betweenSteps(field, {lo, hi}) : glm::vec2(1.0F, 0.0F);
    }
    // Rounding is monotonic, so no voxel inside the range is refused even where integers exceed float's
    // precision.
    glm::vec2 ends(static_cast<float>(lo), static_cast<float>(hi));
    if (!(lo <= hi)) {
        ends = {1.0F, 0.0F}; // rounding must not make an empty range hold a value
    }
    return ends;
}

glm::vec2 comparableDifference(const field::Field& field, const std::optional<Range>& range) {
    return range && field.step > 0 ? halvesAround(0, field.step, *range) : ends(range);
}

glm::mat3 gradientColumns(const field::Field& field) {
    return {glm::transpose(glm::inverse(glm::dmat3(field.geometry.worldFromVoxel))) * 0.5};
}

bool isInRange(const field::Field& field, const Range& range, double value) {
    const glm::vec2 ends = comparableRange(field, range);
    const auto stored = static_cast<float>(value);
    return stored >= ends.x && stored <= ends.y;
}

gl::Program& ConstrainedProgram::prepare(const field::Field& field, const Constraints& constraints,
                                         const gl::Defines& more) {
    gl::Defines defines = definesOf(constraints);
    defines.insert(defines.end(), more.begin(), more.end());
    gl::Program& program = variants_.with(defines);
    field.texels.bindTexture(kDataTexture);
    const glm::mat3 gradient = gradientColumns(field);
    program.set("gridDims", field.geometry.dims)
        .set("valueScale", glm::vec3(field.valueScale, field.valueOffset, field.isIntegral ? 1.0F : 0.0F))
        .set("valueRange", comparableRange(field, constraints.range))
        .set("gradientAlongX", gradient[0])
        .set("gradientAlongY", gradient[1])
        .set("gradientAlongZ", gradient[2])
        .set("gradientRange", ends(constraints.gradient))
        .set("differenceRange", comparableDifference(field, constraints.difference))
        .set("gradientDifferenceRange", ends(constraints.gradientDifference));
    if (constraints.hasFence()) {
        constraints.sculpture->bindTexture(kSculptureTexture);
        program.set("keepsCutPart", constraints.view == field::SculptureView::Probe ? 1 : 0);
    }
    return program;
}

} // namespace vs::segment
