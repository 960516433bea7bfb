// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/read.h"
#include "volume/store/write_store.h"

#include <optional>

namespace vs::volume {

// What a store is made of where a volume is read slice by slice, so that it need not fit into memory: stacks
// of TIFF pictures and raw files. Nothing for other formats, which are read as a whole.
//
// The store's chunks must be of `chunk` voxels: so many slices are in memory at once, read again for each
// slab of chunks only. Throws ReadError, and UsageError where they need more than `memoryBytes`.
std::optional<StoreSource> stackSource(const std::filesystem::path& path, const ReadOptions& options,
                                       int chunk, std::uint64_t memoryBytes,
                                       std::vector<std::string>& notices);

} // namespace vs::volume
