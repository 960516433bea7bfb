// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/store/multiscales.h"

#include <span>
#include <vector>

// Smallest and largest values of a store's finest level in cells, in an array of the store's own beside its
// levels (axes z, y, x and lo, hi): what can be seen where is known from them before any voxel is read.
namespace vs::volume {

// How stores keep values of a type.
StoredType storedTypeOf(ScalarType type);

// Voxels along each side of a cell of a level in chunks of so many: a power of two that divides them, as
// small as some tens of millions of cells allow. 0: there is none.
int extremesSide(glm::ivec3 dims, int chunk);

// The array of such cells in a store of values of a type. Its chunks are as deep as those of the level, and
// have all cells of a slice.
ZarrArray extremesArray(const std::filesystem::path& store, const ZarrArray& finest, glm::ivec3 dims,
                        int side);

// The extremes of a slab of chunks, gathered chunk by chunk, by several threads at once.
class SlabExtremes {
public:
    // The slab is that of the chunks from slice `firstZ` on.
    SlabExtremes(const ZarrArray& extremes, ScalarType type, int side, int firstZ);

    // The values of a box of the slab, whose lower corner is a cell's.
    void add(const Box3& box, std::span<const std::byte> values);
    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
    ScalarType type_;
    int side_;
    int firstZ_;
    glm::ivec3 cells_;
    std::vector<std::byte> bytes_;
};

// All of a store that has them; nothing: it has none. Throws ReadError.
std::optional<CellExtremes> readExtremes(const Multiscales& store);

// From the smallest to the largest of all values that were measured; nothing: it has no extremes, or no such
// values. Throws ReadError.
std::optional<Range> rangeOfExtremes(const Multiscales& store);

} // namespace vs::volume
