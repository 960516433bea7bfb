// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vs::volume {

// Smallest and largest value in cells of a level's grid, known before any voxel is read.
struct CellExtremes {
    int side = 0;        // voxels of the finest level along each side of a cell
    glm::ivec3 cells{0}; // how many there are
    ScalarType type = ScalarType::Float32;
    // Two values of the type for each cell, its smallest and its largest; x fastest, then y, then z.
    std::vector<std::byte> ranges;
};

// A scan in levels, each coarser than the one before, of which any box can be had without the rest.
class BrickSource {
public:
    BrickSource() = default;
    virtual ~BrickSource() = default;
    BrickSource(const BrickSource&) = delete;
    BrickSource& operator=(const BrickSource&) = delete;

    // The grids of its levels, the finest first.
    [[nodiscard]] virtual const std::vector<GridGeometry>& levels() const = 0;
    [[nodiscard]] virtual ScalarType type() const = 0;
    // What messages call it.
    [[nodiscard]] virtual std::string name() const = 0;
    // The values of a box of a level, which must lie in its grid, x fastest. Threads may call it at once.
    // Throws ReadError.
    [[nodiscard]] virtual std::vector<std::byte> read(int level, const Box3& box) const = 0;
    // What the finest level holds where; nothing: that is not known. Throws ReadError.
    [[nodiscard]] virtual std::optional<CellExtremes> extremes() const { return {}; }
};

// The values of a box of a volume in memory, x fastest.
std::vector<std::byte> valuesIn(const Volume& volume, const Box3& box);

// A volume in memory, of one level; it must live as long.
class VolumeBricks : public BrickSource {
public:
    // `geometry` says where its voxels lie.
    VolumeBricks(const Volume& volume, const GridGeometry& geometry) : volume_(volume), levels_{geometry} {}

    [[nodiscard]] const std::vector<GridGeometry>& levels() const override { return levels_; }
    [[nodiscard]] ScalarType type() const override { return volume_.type; }
    [[nodiscard]] std::string name() const override { return volume_.name; }
    [[nodiscard]] std::vector<std::byte> read(int /*level*/, const Box3& box) const override {
        return valuesIn(volume_, box);
    }

private:
    const Volume& volume_;
    std::vector<GridGeometry> levels_;
};

} // namespace vs::volume
