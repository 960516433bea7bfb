// SPDX-License-Identifier: Apache-2.0
#include "volume/store/codec.h"

#include "base/error.h"

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace vs::volume {

namespace {

using Bytes = std::vector<std::byte>;

void expectSize(std::size_t held, std::size_t wanted) {
    if (held != wanted) {
        throw Error("it holds {} bytes of the {} that it should", held, wanted);
    }
}

Bytes inflated(std::span<const std::byte> chunk, std::size_t size) {
    constexpr int anyHeader = 15 + 32; // zlib's or gzip's
    Bytes out(size);
    z_stream stream{};
    if (inflateInit2(&stream, anyHeader) != Z_OK) {
        throw Error("zlib has no memory for it");
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(chunk.data()));
    stream.avail_in = uInt(chunk.size());
    std::byte beyond{};
    stream.next_out = reinterpret_cast<Bytef*>(size > 0 ? out.data() : &beyond);
    stream.avail_out = uInt(size);
    int state = inflate(&stream, Z_FINISH);
    const bool isFull = stream.avail_out == 0;
    if (isFull && state != Z_STREAM_END) { // is there more than there should be?
        stream.next_out = reinterpret_cast<Bytef*>(&beyond);
        stream.avail_out = 1;
        state = inflate(&stream, Z_FINISH);
    }
    const std::size_t held = stream.total_out;
    inflateEnd(&stream);
    if (state != Z_STREAM_END && held <= size) {
        throw Error("it is cut short or damaged (zlib)");
    }
    expectSize(held, size);
    return out;
}

Bytes deflated(std::span<const std::byte> values, int level, bool isGzip) {
    z_stream stream{};
    constexpr int window = 15;
    constexpr int memory = 8;
    if (deflateInit2(&stream, level, Z_DEFLATED, isGzip ? window + 16 : window, memory, Z_DEFAULT_STRATEGY) !=
        Z_OK) {
        throw Error("zlib has no memory for a chunk, or knows no level {}", level);
    }
    Bytes out(deflateBound(&stream, uLong(values.size())));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(values.data()));
    stream.avail_in = uInt(values.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = uInt(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

Bytes ofZstd(std::span<const std::byte> chunk, std::size_t size) {
    Bytes out(size);
    const std::size_t held = ZSTD_decompress(out.data(), out.size(), chunk.data(), chunk.size());
    if (ZSTD_isError(held) != 0) {
        throw Error("it is cut short or damaged (zstd: {})", ZSTD_getErrorName(held));
    }
    expectSize(held, size);
    return out;
}

Bytes toZstd(std::span<const std::byte> values, int level) {
    Bytes out(ZSTD_compressBound(values.size()));
    const std::size_t size = ZSTD_compress(out.data(), out.size(), values.data(), values.size(), level);
    if (ZSTD_isError(size) != 0) {
        throw Error("zstd cannot compress a chunk ({})", ZSTD_getErrorName(size));
    }
    out.resize(size);
    return out;
}

Bytes ofBlosc(std::span<const std::byte> chunk, std::size_t size) {
    std::size_t held = 0;
    if (chunk.size() < BLOSC_MIN_HEADER_LENGTH ||
        blosc_cbuffer_validate(chunk.data(), chunk.size(), &held) != 0) {
        throw Error("it is cut short or damaged (blosc)");
    }
    expectSize(held, size);
    Bytes out(size);
    if (blosc_decompress_ctx(chunk.data(), out.data(), out.size(), 1) != int(size)) {
        throw Error("it is damaged (blosc)");
    }
    return out;
}

Bytes toBlosc(std::span<const std::byte> values, const Codec& codec, std::size_t valueBytes) {
    Bytes out(values.size() + BLOSC_MAX_OVERHEAD);
    const int size = blosc_compress_ctx(std::min(codec.level, 9), codec.shuffle, valueBytes, values.size(),
                                        values.data(), out.data(), out.size(), codec.inner.c_str(), 0, 1);
    if (size <= 0) {
        throw Error("blosc cannot compress a chunk by {}", codec.inner);
    }
    out.resize(std::size_t(size));
    return out;
}

} // namespace

Bytes decoded(const Codec& codec, std::span<const std::byte> chunk, std::size_t size) {
    if (chunk.size() > std::numeric_limits<uInt>::max() || size > std::numeric_limits<int>::max()) {
        throw Error("it is larger than 2 GiB");
    }
    switch (codec.kind) {
    case Codec::Kind::None:
        expectSize(chunk.size(), size);
        return {chunk.begin(), chunk.end()};
    case Codec::Kind::Zlib:
    case Codec::Kind::Gzip:
        return inflated(chunk, size);
    case Codec::Kind::Zstd:
        return ofZstd(chunk, size);
    case Codec::Kind::Blosc:
        break;
    }
    return ofBlosc(chunk, size);
}

Bytes encoded(const Codec& codec, std::span<const std::byte> values, std::size_t valueBytes) {
    switch (codec.kind) {
    case Codec::Kind::None:
        return {values.begin(), values.end()};
    case Codec::Kind::Zlib:
        return deflated(values, codec.level, false);
    case Codec::Kind::Gzip:
        return deflated(values, codec.level, true);
    case Codec::Kind::Zstd:
        return toZstd(values, codec.level);
    case Codec::Kind::Blosc:
        break;
    }
    return toBlosc(values, codec, valueBytes);
}

} // namespace vs::volume
