// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/growth.h"
#include "segment/growth.h"
#include "volume/phantom.h"

#include <random>
#include <vector>

namespace vs::segment {

inline volume::Volume randomVolume(glm::ivec3 dims, volume::ScalarType type, double lo, double hi,
                                   unsigned int seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(lo, hi);
    return volume::makePhantom(dims, type, [&](glm::dvec3) { return value(random); });
}

// What the reference admits: the volume's own values, and a sculpture given as one value a voxel (empty:
// none).
inline reference::QueueGrowth::Admits admits(const volume::Volume& volume, const Constraints& constraints,
                                             const std::vector<std::uint8_t>& sculpture = {}) {
    return [&volume, constraints, sculpture](glm::ivec3 v) {
        const double value = volume.at(v);
        const bool inRange =
            volume.type == volume::ScalarType::Float32
                ? float(value) >= float(constraints.range.lo) && float(value) <= float(constraints.range.hi)
                : constraints.range.contains(value);
        if (sculpture.empty() || constraints.view == field::SculptureView::Whole) {
            return inRange;
        }
        const glm::ivec3 dims = volume.geometry.dims;
        const bool isCut = sculpture[std::size_t((v.z * dims.y + v.y) * dims.x + v.x)] >= 128;
        return inRange && isCut == (constraints.view == field::SculptureView::Probe);
    };
}

} // namespace vs::segment
