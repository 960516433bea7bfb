// SPDX-License-Identifier: Apache-2.0
#include "value_counts.h"

namespace vs::cli {

bool hasFewValues(const volume::Volume& volume) {
    constexpr double most = 65536;
    return volume.type != volume::ScalarType::Float32 && volume.range.width() < most;
}

std::vector<std::uint64_t> countsPerValue(const volume::Volume& volume) {
    std::vector<std::uint64_t> counts(std::size_t(volume.range.width()) + 1);
    volume::visit(volume, [&](const auto* values) {
        const auto lowest = std::int64_t(volume.range.lo);
        for (std::size_t i = 0; i < volume.geometry.voxelCount(); ++i) {
            ++counts[std::size_t(std::int64_t(values[i]) - lowest)];
        }
    });
    return counts;
}

} // namespace vs::cli
