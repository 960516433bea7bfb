// SPDX-License-Identifier: Apache-2.0
#include "phantom/scanner.h"

#include "base/parallel.h"

namespace vs::phantom {

void scanBox(const Scanner& scanner, const Box3& box, std::span<std::byte> values,
             std::span<std::uint8_t> labels) {
    const std::size_t slice = std::size_t(box.size().x) * std::size_t(box.size().y);
    const std::size_t bytes = volume::sizeOf(scanner.type);
    inParallel(box.size().z, [&](int n) {
        Box3 own = box;
        own.lo.z = box.lo.z + n;
        own.hi.z = own.lo.z + 1;
        const std::size_t first = slice * std::size_t(n);
        scanner.scan(own, values.subspan(bytes * first, bytes * slice),
                     labels.empty() ? labels : labels.subspan(first, slice));
    });
}

LabelledVolume scanAll(const Scanner& scanner) {
    LabelledVolume all;
    const glm::ivec3 dims = scanner.grid.dims;
    all.volume.geometry = scanner.grid;
    all.volume.type = scanner.type;
    all.volume.name = scanner.name;
    all.volume.bytes.resize(scanner.grid.voxelCount() * volume::sizeOf(scanner.type));
    all.labels.resize(scanner.grid.voxelCount());
    scanBox(scanner, {glm::ivec3(0), dims}, all.volume.bytes, all.labels);
    volume::computeRange(all.volume);
    return all;
}

volume::GridGeometry phantomGrid(glm::ivec3 dims, glm::dvec3 extentMm) {
    auto grid = volume::makeGeometry(dims, extentMm / glm::dvec3(dims));
    grid.worldFromVoxel[3] = glm::dvec4(0.5 * (grid.spacing() - extentMm), 1);
    return grid;
}

} // namespace vs::phantom
