// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/store/multiscales.h"

#include <array>

namespace vs::volume {

// How a box of voxels of one level lies in its chunks; the store must live as long.
class BoxReader {
public:
    // `channel` and `time` are of the axes that the store has for them.
    BoxReader(const Multiscales& store, std::size_t level, const Box3& box, int channel = 0, int time = 0);

    [[nodiscard]] int chunks() const { return count_.x * count_.y * count_.z; }
    [[nodiscard]] std::filesystem::path file(int n) const { return array_.chunkFile(chunkAt(n)); }
    // The size of chunk n's file, 0 where it has none.
    [[nodiscard]] std::uint64_t storedBytes(int n) const { return array_.storedBytes(chunkAt(n)); }

    // Chunk n's part of the box, or what fills it where it has no file, put in its place among the box's
    // values (x fastest). Throws ReadError.
    void readInto(std::span<std::byte> out, int n) const;

private:
    [[nodiscard]] glm::ivec3 placeOf(int n) const;
    [[nodiscard]] std::vector<std::int64_t> chunkAt(int n) const;
    // Byte of a voxel in its chunk.
    [[nodiscard]] std::size_t offsetOf(glm::ivec3 inChunk) const;
    void copyRow(std::byte* to, std::size_t bytes, const std::byte* from) const;

    const Multiscales& store_;
    const ZarrArray& array_;
    Box3 box_;
    std::size_t valueBytes_;
    std::vector<std::int64_t> fixed_;     // index along the axes that are not of space
    std::vector<std::int64_t> strides_;   // of a chunk, in values
    glm::ivec3 side_{1};                  // of a chunk, in voxels
    std::array<std::size_t, 3> stride_{}; // of a chunk, in bytes, along x, y and z
    glm::ivec3 first_{0};                 // chunk that the box begins in
    glm::ivec3 count_{0};
};

// The values of a box of a level, x fastest, bytesOf(type) each, read by the calling thread. Missing chunks
// are filled.
std::vector<std::byte> readBox(const Multiscales& store, std::size_t level, const Box3& box, int channel = 0,
                               int time = 0);

} // namespace vs::volume
