// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/brick_source.h"
#include "volume/grid/reduced.h"
#include "volume/store/multiscales.h"

#include <functional>

namespace vs::volume {

// Whether a file that is to be written is a store.
inline bool isStoreName(const std::filesystem::path& path) { return path.extension() == ".zarr"; }

// What a store is to hold, whoever has it: never more than a few chunks at once are asked for.
struct StoreSource {
    StoreFacts facts;
    ScalarType type = ScalarType::UInt8;
    // The values of a box of the finest level, x fastest; called by several threads at once.
    std::function<std::vector<std::byte>(const Box3&)> read;
    // Whether a box of it is known to hold nothing but zeros, before it is read; null: that is known of none.
    std::function<bool(const Box3&)> isZero = {};
    // In one line, what tells it from anything else: only the same is gone on with.
    std::string identity;
};

// All of a volume that is in memory; it must live as long as the source.
StoreSource sourceOf(const Volume& volume);

struct StoreLayout {
    int chunk = 64; // voxels along each side of a chunk
    Codec codec;
    Reducing reducing = Reducing::Mean;
};

// The grids of a store's levels: each half as fine as the one before along the axes that have more than one
// voxel, until all fits into one chunk.
std::vector<GridGeometry> levelsOf(const GridGeometry& finest, int chunk);

// Writes a store of OME-Zarr 0.4 with its levels, each made of the one before as that lies on the disk, so
// that memory is needed for a few chunks on each processor only. Chunks that hold nothing but zeros get no
// file. Reports progress; when it is given up, or fails, writing the same again goes on where it stopped.
// Throws WriteError.
void writeStore(const std::filesystem::path& path, const StoreSource& source, const StoreLayout& layout = {});

} // namespace vs::volume
