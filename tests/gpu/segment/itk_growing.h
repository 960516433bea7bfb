// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <vector>

namespace vs::test {

// ITK's ConnectedThresholdImageFilter on a volume's values: 1 in the region, else 0. `milliseconds`, when
// given, gets what the filter alone took.
std::vector<std::uint8_t> growWithItk(const volume::Volume& volume, const std::vector<glm::ivec3>& seeds,
                                      Range range, bool cornersTouch, double* milliseconds = nullptr);

// ITK's NeighborhoodConnectedImageFilter likewise: enters voxels across faces whose whole neighbourhood of
// (2 radius + 1)^3 lies in the range; beyond the grid it takes the values at its border.
std::vector<std::uint8_t> growNeighbourhoodsWithItk(const volume::Volume& volume,
                                                    const std::vector<glm::ivec3>& seeds, Range range,
                                                    int radius);

} // namespace vs::test
