// SPDX-License-Identifier: Apache-2.0
#include "phantom/scanner.h"

#include "base/parallel.h"

namespace vs::phantom {

LabelledVolume scanAll(const Scanner& scanner) {
    LabelledVolume all;
    const glm::ivec3 dims = scanner.grid.dims;
    all.volume.geometry = scanner.grid;
    all.volume.type = scanner.type;
    all.volume.name = scanner.name;
    all.volume.bytes.resize(scanner.grid.voxelCount() * volume::sizeOf(scanner.type));
    all.labels.resize(scanner.grid.voxelCount());
    const std::size_t slice = std::size_t(dims.x) * std::size_t(dims.y);
    inParallel(dims.z, [&](int z) {
        const std::size_t first = slice * std::size_t(z);
        const std::size_t bytes = volume::sizeOf(scanner.type);
        scanner.scan({{0, 0, z}, {dims.x, dims.y, z + 1}},
                     std::span(all.volume.bytes).subspan(bytes * first, bytes * slice),
                     std::span(all.labels).subspan(first, slice));
    });
    volume::computeRange(all.volume);
    return all;
}

volume::GridGeometry phantomGrid(glm::ivec3 dims, glm::dvec3 extentMm) {
    auto grid = volume::makeGeometry(dims, extentMm / glm::dvec3(dims));
    grid.worldFromVoxel[3] = glm::dvec4(0.5 * (grid.spacing() - extentMm), 1);
    return grid;
}

} // namespace vs::phantom
