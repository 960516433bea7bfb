// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl_test.h"
#include "phantom/phantom.h"
#include "reference/growth.h"
#include "segment/growth/growth.h"
#include "segment/membership/segmentation.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace vs::segment {

// A test of growth, on the device and on the host.
class GrowthCase : public test::GlTest, public testing::WithParamInterface<GrowthEngine> {};
inline const auto kEngines = testing::Values(GrowthEngine::Device, GrowthEngine::Host);
inline std::string nameOfEngine(const testing::TestParamInfo<GrowthEngine>& engine) {
    return engine.param == GrowthEngine::Device ? "Device" : "Host";
}

// The last of all generations.
inline constexpr int kAll = std::numeric_limits<int>::max();

inline std::vector<std::uint8_t> texelsOf(const Segmentation& segmentation) {
    return segmentation.texels().downloadAll<std::uint8_t>();
}

inline volume::Volume randomVolume(glm::ivec3 dims, volume::ScalarType type, double lo, double hi,
                                   unsigned int seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(lo, hi);
    return phantom::makePhantom(dims, type, [&](glm::dvec3) { return value(random); });
}

// What the reference admits: the volume's own values, and a sculpture given as one value a voxel (empty:
// none).
inline float gradientMagnitude(const volume::Volume& volume, glm::ivec3 v);

inline reference::QueueGrowth::Admits admits(const volume::Volume& volume, const Constraints& constraints,
                                             const std::vector<std::uint8_t>& sculpture = {}) {
    return [&volume, constraints, sculpture](glm::ivec3 v) {
        const double value = volume.at(v);
        const bool inRange =
            volume.type == volume::ScalarType::Float32
                ? float(value) >= float(constraints.range.lo) && float(value) <= float(constraints.range.hi)
                : constraints.range.contains(value);
        if (constraints.gradient) {
            const float magnitude = gradientMagnitude(volume, v);
            if (magnitude < float(constraints.gradient->lo) || magnitude > float(constraints.gradient->hi)) {
                return false;
            }
        }
        if (sculpture.empty() || constraints.view == field::SculptureView::Whole) {
            return inRange;
        }
        const glm::ivec3 dims = volume.geometry.dims;
        const bool isCut = sculpture[(std::size_t(v.z) * dims.y + v.y) * dims.x + v.x] >= 128;
        return inRange && isCut == (constraints.view == field::SculptureView::Probe);
    };
}

// The gradient's magnitude as constraints.glsl computes it: float, one rounding after another.
inline float gradientMagnitude(const volume::Volume& volume, glm::ivec3 v) {
    const glm::mat3 columns(glm::transpose(glm::inverse(glm::dmat3(volume.geometry.worldFromVoxel))) * 0.5);
    const auto difference = [&](int axis) {
        glm::ivec3 before = v;
        glm::ivec3 after = v;
        before[axis] = std::max(v[axis] - 1, 0);
        after[axis] = std::min(v[axis] + 1, volume.geometry.dims[axis] - 1);
        return float(volume.at(after)) - float(volume.at(before));
    };
    float squared = 0;
    const float along[3] = {difference(0), difference(1), difference(2)};
    for (int i = 0; i < 3; ++i) {
        const float x = columns[0][i] * along[0];
        const float y = columns[1][i] * along[1];
        const float z = columns[2][i] * along[2];
        const float xy = x + y;
        const float component = xy + z;
        const float square = component * component;
        squared += square;
    }
    return std::sqrt(squared);
}

// What the reference admits from a parent; empty when no rule asks for it.
inline reference::QueueGrowth::AdmitsFrom admitsFrom(const volume::Volume& volume,
                                                     const Constraints& constraints) {
    if (!constraints.difference && !constraints.gradientDifference) {
        return {};
    }
    return [&volume, constraints](glm::ivec3 parent, glm::ivec3 child) {
        const auto isWithin = [](float value, const std::optional<Range>& range) {
            return !range || (value >= float(range->lo) && value <= float(range->hi));
        };
        return isWithin(float(volume.at(child)) - float(volume.at(parent)), constraints.difference) &&
               (!constraints.gradientDifference ||
                isWithin(gradientMagnitude(volume, child) - gradientMagnitude(volume, parent),
                         constraints.gradientDifference));
    };
}

} // namespace vs::segment
