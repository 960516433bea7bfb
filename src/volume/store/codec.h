// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

// How the chunks of a Zarr array are compressed: by kept libraries (c-blosc, zstd, zlib), one of them at a
// time.
namespace vs::volume {

struct Codec {
    enum class Kind { None, Zlib, Gzip, Zstd, Blosc };

    Kind kind = Kind::Blosc;
    int level = 5;
    std::string inner = "lz4"; // of Blosc: its own compressor
    int shuffle = 1;           // of Blosc: 0 none, 1 bytes, 2 bits
};

// What an encoded chunk is decoded to, `size` bytes. Throws Error saying in a few words what is wrong where
// it is damaged or holds another number of bytes.
std::vector<std::byte> decoded(const Codec& codec, std::span<const std::byte> chunk, std::size_t size);

// A chunk encoded; `valueBytes` is the size of one value.
std::vector<std::byte> encoded(const Codec& codec, std::span<const std::byte> values, std::size_t valueBytes);

} // namespace vs::volume
