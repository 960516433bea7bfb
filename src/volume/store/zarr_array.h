// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/io/inspect.h"
#include "volume/store/codec.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vs::volume {

// One Zarr array of version 2 (zarr-specs, "Zarr storage specification version 2"): values in a grid of any
// number of axes, the last of which is the fastest, in chunks of one shape, each a file of the array's
// folder. A chunk that has no file holds the fill value. Chunks at the far ends are whole too; what lies
// beyond the array means nothing.
struct ZarrArray {
    std::filesystem::path folder;
    std::vector<std::int64_t> shape;  // 1 or more along each axis
    std::vector<std::int64_t> chunks; // as many axes
    StoredType type = StoredType::UInt8;
    bool isBigEndian = false;
    Codec codec;
    double fill = 0;
    char separator = '/'; // between the numbers of a chunk's file name; '/' makes folders

    [[nodiscard]] std::size_t chunkBytes() const;
    // How many chunks there are along an axis.
    [[nodiscard]] std::int64_t chunkCount(std::size_t axis) const;
    [[nodiscard]] std::filesystem::path chunkFile(std::span<const std::int64_t> chunk) const;

    // A chunk's values in this machine's byte order; nothing: it has no file. Throws ReadError naming it.
    [[nodiscard]] std::optional<std::vector<std::byte>> readChunk(std::span<const std::int64_t> chunk) const;
    // Its file's size, 0 where there is none.
    [[nodiscard]] std::uint64_t storedBytes(std::span<const std::int64_t> chunk) const;
    // Writes a chunk under a name of its own first, and then renames it. Throws WriteError.
    void writeChunk(std::span<const std::int64_t> chunk, std::span<const std::byte> values) const;
    // From now on it holds the fill value. Throws WriteError.
    void removeChunk(std::span<const std::int64_t> chunk) const;
    // One value as it fills chunks that have no file, bytesOf(type) bytes in this machine's order.
    [[nodiscard]] std::vector<std::byte> fillValue() const;
};

// The array of a folder with a file .zarray. Throws ReadError where that is missing, says what this program
// does not read, or makes no sense.
ZarrArray openZarrArray(const std::filesystem::path& folder);

// Makes the folder with its .zarray. Throws WriteError.
void createZarrArray(const ZarrArray& array);

} // namespace vs::volume
