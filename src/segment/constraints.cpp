// SPDX-License-Identifier: Apache-2.0
#include "segment/constraints.h"

#include <cmath>

namespace vs::segment {

glm::vec2 comparableRange(const field::Field& field, const Range& range) {
    double lo = std::max(range.lo, field.range.lo);
    double hi = std::min(range.hi, field.range.hi);
    if (field.isIntegral) {
        lo = std::ceil(lo);
        hi = std::floor(hi);
    }
    // Rounding is monotonic, so no voxel inside the range is refused even where integers exceed float's
    // precision.
    glm::vec2 ends(static_cast<float>(lo), static_cast<float>(hi));
    if (!(lo <= hi)) {
        ends = {1.0F, 0.0F}; // rounding must not make an empty range hold a value
    }
    return ends;
}

bool isInRange(const field::Field& field, const Range& range, double value) {
    const glm::vec2 ends = comparableRange(field, range);
    const auto stored = static_cast<float>(value);
    return stored >= ends.x && stored <= ends.y;
}

gl::Program constrainedProgram(const std::string& path, bool hasFence) {
    return hasFence ? gl::Program(path, {{"VS_FENCED", "1"}}) : gl::Program(path);
}

void bindConstraints(gl::Program& program, const field::Field& field, const Constraints& constraints) {
    field.texels.bindTexture(0);
    program.set(20, field.geometry.dims)
        .set(21, glm::vec3(field.valueScale, field.valueOffset, field.isIntegral ? 1.0F : 0.0F))
        .set(22, comparableRange(field, constraints.range));
    if (constraints.hasFence()) {
        constraints.sculpture->bindTexture(1);
        program.set(23, constraints.view == field::SculptureView::Probe ? 1 : 0);
    }
}

} // namespace vs::segment
