// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vs::phantom {

// A volume and what is truly in it, one label a voxel.
struct LabelledVolume {
    volume::Volume volume;
    std::vector<std::uint8_t> labels; // of HeadTissue for a head
};

// How a phantom is measured: any box of its grid by itself, always the same however it is cut into boxes.
struct Scanner {
    std::string name;
    volume::GridGeometry grid;
    volume::ScalarType type = volume::ScalarType::UInt8;
    // Values and labels of the voxels of a box, x fastest; of labels none are wanted where there is no room
    // for any. Threads may call it at once.
    std::function<void(const Box3& box, std::span<std::byte> values, std::span<std::uint8_t> labels)> scan;
};

// A box of it, on all processors: see Scanner::scan.
void scanBox(const Scanner& scanner, const Box3& box, std::span<std::byte> values,
             std::span<std::uint8_t> labels);
// All of it, on all processors.
LabelledVolume scanAll(const Scanner& scanner);

// What one voxel holds.
struct Measured {
    double value = 0; // as the type has it, but for rounding
    std::uint8_t label = 0;
};

// A scanner of values of type T that `measure(place in the world, number of the voxel, x fastest)` gives.
template <typename T, typename Measure>
Scanner scannerOf(std::string name, const volume::GridGeometry& grid, volume::ScalarType type,
                  Measure measure) {
    return {std::move(name), grid, type,
            [grid, measure = std::move(measure)](const Box3& box, std::span<std::byte> values,
                                                 std::span<std::uint8_t> labels) {
                const auto row = std::size_t(grid.dims.x);
                const std::size_t slice = row * std::size_t(grid.dims.y);
                auto* out = reinterpret_cast<T*>(values.data());
                forEachVoxel(box, [&](glm::ivec3 v, std::size_t i) {
                    const auto place = glm::dvec3(grid.worldFromVoxel * glm::dvec4(v, 1));
                    const std::size_t n =
                        slice * std::size_t(v.z) + row * std::size_t(v.y) + std::size_t(v.x);
                    const Measured measured = measure(place, n);
                    out[i] = T(measured.value);
                    if (!labels.empty()) {
                        labels[i] = measured.label;
                    }
                });
            }};
}

// The grid of a phantom that covers `extentMm` around the world's origin.
volume::GridGeometry phantomGrid(glm::ivec3 dims, glm::dvec3 extentMm);

} // namespace vs::phantom
