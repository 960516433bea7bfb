// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl_test.h"
#include "sculpt/surface/tool_cut.h"
#include "surface_makers.h"

#include <vector>

namespace vs::test {

// A grid with a sculpture and the means to cut it.
struct Workpiece {
    explicit Workpiece(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1),
                       sculpt::Precision precision = sculpt::Precision::Bits16)
        : geometry(volume::makeGeometry(dims, spacing)), sculpture(dims, precision), cutter(geometry) {}

    Box3 cut(const std::vector<field::SurfacePoint>& surface, const sculpt::MaskRaster& mask,
             const sculpt::ToolCut& how, sculpt::BrickBackup* backup = nullptr) {
        return cutter.cut(sculpture, std::span(surface), mask, how, backup);
    }
    [[nodiscard]] std::vector<std::byte> bytes() const { return sculpture.download(geometry.box()); }
    [[nodiscard]] std::vector<float> values() const { return sculpture.values(geometry.box()); }
    [[nodiscard]] glm::ivec3 dims() const { return geometry.dims; }

    volume::GridGeometry geometry;
    sculpt::Sculpture sculpture;
    sculpt::ToolCutter cutter;
};

inline sculpt::ToolCut drill(double depth, glm::dvec3 direction = {0, 0, 1}) {
    sculpt::ToolCut cut;
    cut.sweep.directionWorld = direction;
    cut.sweep.depthSteps = depth;
    return cut;
}

inline sculpt::ToolCut peel(double layers) {
    sculpt::ToolCut cut;
    cut.sweep.direction = sculpt::ToolDirection::OwnNormal;
    cut.sweep.depthSteps = layers;
    return cut;
}

inline float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
    float worst = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        worst = std::max(worst, std::abs(a[n] - b[n]));
    }
    return worst;
}

} // namespace vs::test
