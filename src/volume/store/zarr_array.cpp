// SPDX-License-Identifier: Apache-2.0
#include "volume/store/zarr_array.h"

#include "base/atomic_file.h"
#include "base/json_file.h"
#include "base/json_reader.h"
#include "volume/store/store_json.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace vs::volume {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostAxes = 8;
constexpr std::int64_t kMostChunkBytes = std::int64_t(1) << 30;

struct NamedType {
    const char* code; // of numpy, without the byte order
    StoredType type;
};
constexpr std::array<NamedType, 11> kTypes{{{"u1", StoredType::UInt8},
                                            {"b1", StoredType::UInt8},
                                            {"i1", StoredType::Int8},
                                            {"u2", StoredType::UInt16},
                                            {"i2", StoredType::Int16},
                                            {"u4", StoredType::UInt32},
                                            {"i4", StoredType::Int32},
                                            {"u8", StoredType::UInt64},
                                            {"i8", StoredType::Int64},
                                            {"f4", StoredType::Float32},
                                            {"f8", StoredType::Float64}}};

void readType(const JsonReader& from, ZarrArray& array) {
    if (from.isText() && from.text().size() > 1) {
        const std::string text = from.text();
        const auto* found = std::find_if(kTypes.begin(), kTypes.end(),
                                         [&](const NamedType& one) { return text.substr(1) == one.code; });
        if (found != kTypes.end() && std::string("<>|=").find(text[0]) != std::string::npos) {
            array.type = found->type;
            array.isBigEndian = text[0] == '>';
            return;
        }
    }
    from.fail("values of this type cannot be read; whole numbers of 1 to 8 bytes and floats of 4 and 8 can, "
              "as \"<u2\" and \"<f4\"");
}

constexpr std::int64_t kMostAlongAxis = std::int64_t(1) << 27;

std::vector<std::int64_t> readSizes(const JsonReader& from) {
    std::vector<std::int64_t> sizes;
    for (std::size_t axis = 0; axis < std::min(from.size(), kMostAxes + 1); ++axis) {
        sizes.push_back(from.at(axis).integerBetween(1, kMostAlongAxis));
    }
    if (sizes.empty() || sizes.size() > kMostAxes) {
        from.fail(fmt::format("must be 1 to {} numbers", kMostAxes));
    }
    return sizes;
}

double readFill(const JsonReader& from) {
    if (from.isNull()) {
        return 0; // nothing is said of what has no file
    }
    if (from.json().is_boolean()) {
        return from.boolean() ? 1 : 0;
    }
    if (from.isText()) {
        const std::string text = from.text();
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (text == "NaN") {
            return std::numeric_limits<double>::quiet_NaN();
        }
        if (text == "Infinity" || text == "-Infinity") {
            return text[0] == '-' ? -infinity : infinity;
        }
        from.fail("must be a number, \"NaN\", \"Infinity\" or \"-Infinity\"");
    }
    return from.json().is_number() ? from.json().get<double>() : from.number();
}

Codec readCodec(const JsonReader& from) {
    Codec codec;
    if (from.isNull()) {
        codec.kind = Codec::Kind::None;
        return codec;
    }
    const std::string id = from.member("id").text();
    if (id == "blosc") {
        codec.kind = Codec::Kind::Blosc;
    } else if (id == "zstd") {
        codec.kind = Codec::Kind::Zstd;
    } else if (id == "zlib") {
        codec.kind = Codec::Kind::Zlib;
    } else if (id == "gzip") {
        codec.kind = Codec::Kind::Gzip;
    } else {
        from.member("id").fail(
            fmt::format("chunks that '{}' compressed cannot be read; blosc, zstd, zlib, gzip and none can",
                        printable(id)));
    }
    return codec;
}

nlohmann::ordered_json written(const Codec& codec) {
    switch (codec.kind) {
    case Codec::Kind::None:
        return nullptr;
    case Codec::Kind::Zlib:
        return {{"id", "zlib"}, {"level", codec.level}};
    case Codec::Kind::Gzip:
        return {{"id", "gzip"}, {"level", codec.level}};
    case Codec::Kind::Zstd:
        return {{"id", "zstd"}, {"level", codec.level}};
    case Codec::Kind::Blosc:
        break;
    }
    return {{"id", "blosc"},
            {"cname", codec.inner},
            {"clevel", codec.level},
            {"shuffle", codec.shuffle},
            {"blocksize", 0}};
}

std::string codeOf(const ZarrArray& array) {
    const auto* found = std::find_if(kTypes.begin(), kTypes.end(),
                                     [&](const NamedType& one) { return one.type == array.type; });
    const char order = bytesOf(array.type) == 1 ? '|' : array.isBigEndian ? '>' : '<';
    return std::string(1, order) + found->code;
}

ZarrArray readDescription(const JsonReader& from, const fs::path& folder) {
    ZarrArray array;
    array.folder = folder;
    if (from.member("zarr_format").integerBetween(1, 1000) != 2) {
        from.member("zarr_format").fail("only version 2 can be read");
    }
    array.shape = readSizes(from.member("shape"));
    array.chunks = readSizes(from.member("chunks"));
    if (array.chunks.size() != array.shape.size()) {
        from.member("chunks").fail(fmt::format("must be {} numbers, as shape has", array.shape.size()));
    }
    readType(from.member("dtype"), array);
    array.fill = readFill(from.member("fill_value"));
    array.codec = readCodec(from.member("compressor"));
    if (const auto order = from.member("order"); order.text() != "C") {
        order.fail("only arrays whose last axis is the fastest (\"C\") can be read");
    }
    from.ifHas("filters", [](const JsonReader& filters) {
        if (!filters.isNull() && filters.size() > 0) {
            filters.fail("values that went through filters cannot be read; save it without");
        }
    });
    array.separator = '.';
    from.ifHas("dimension_separator", [&](const JsonReader& separator) {
        const std::string text = separator.isNull() ? "." : separator.text();
        if (text != "." && text != "/") {
            separator.fail("must be \".\" or \"/\"");
        }
        array.separator = text[0];
    });
    std::int64_t bytes = std::int64_t(bytesOf(array.type));
    for (const std::int64_t along : array.chunks) {
        if (along > kMostChunkBytes / bytes) {
            from.member("chunks").fail("chunks of more than 1 GiB cannot be read");
        }
        bytes *= along;
    }
    return array;
}

void swapBytes(std::vector<std::byte>& values, std::size_t valueBytes) {
    for (std::size_t at = 0; at + valueBytes <= values.size(); at += valueBytes) {
        std::reverse(values.begin() + std::ptrdiff_t(at), values.begin() + std::ptrdiff_t(at + valueBytes));
    }
}

std::vector<std::byte> bytesIn(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const auto size = stream ? std::streamoff(stream.tellg()) : std::streamoff(-1);
    std::vector<std::byte> bytes(std::size_t(std::max<std::streamoff>(size, 0)));
    stream.seekg(0);
    if (size < 0 || !stream.read(reinterpret_cast<char*>(bytes.data()), size)) {
        throw ReadError(
            "{}: this chunk cannot be read; check its permissions, or get another copy of the store",
            file.string());
    }
    return bytes;
}

template <typename T>
std::vector<std::byte> bytesOfValue(double value) {
    T number{};
    if constexpr (std::is_integral_v<T>) {
        const double lo = double(std::numeric_limits<T>::lowest());
        const double hi = double(std::numeric_limits<T>::max());
        number = value != value ? T(0)
                 : value <= lo  ? std::numeric_limits<T>::lowest()
                 : value >= hi  ? std::numeric_limits<T>::max()
                                : T(value);
    } else {
        number = T(value);
    }
    const auto* bytes = reinterpret_cast<const std::byte*>(&number);
    return {bytes, bytes + sizeof(T)};
}

} // namespace

std::size_t ZarrArray::chunkBytes() const {
    std::size_t bytes = bytesOf(type);
    for (const std::int64_t along : chunks) {
        bytes *= std::size_t(along);
    }
    return bytes;
}

std::int64_t ZarrArray::chunkCount(std::size_t axis) const {
    return (shape[axis] + chunks[axis] - 1) / chunks[axis];
}

fs::path ZarrArray::chunkFile(std::span<const std::int64_t> chunk) const {
    return folder / fmt::format("{}", fmt::join(chunk, std::string(1, separator)));
}

std::uint64_t ZarrArray::storedBytes(std::span<const std::int64_t> chunk) const {
    std::error_code error;
    const auto bytes = fs::file_size(chunkFile(chunk), error);
    return error ? 0 : bytes;
}

std::optional<std::vector<std::byte>> ZarrArray::readChunk(std::span<const std::int64_t> chunk) const {
    const fs::path file = chunkFile(chunk);
    std::error_code error;
    const auto status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) {
        return std::nullopt;
    }
    // No codec makes more of a chunk than some headers.
    const std::uint64_t most = chunkBytes() + chunkBytes() / 4 + (std::uint64_t(1) << 16);
    if (!fs::is_regular_file(status) || fs::file_size(file, error) > most) {
        throw ReadError(
            "{}: this is no chunk of {} bytes; get another copy of it, or remove it to have it empty",
            file.string(), chunkBytes());
    }
    const auto bytes = bytesIn(file);
    try {
        auto values = decoded(codec, bytes, chunkBytes());
        if (isBigEndian != (std::endian::native == std::endian::big)) {
            swapBytes(values, bytesOf(type));
        }
        return values;
    } catch (const ReadError&) {
        throw;
    } catch (const Error& wrong) {
        throw ReadError(
            "{}: this chunk cannot be read: {}; get another copy of it, or remove it to have it empty",
            file.string(), wrong.what());
    }
}

void ZarrArray::writeChunk(std::span<const std::int64_t> chunk, std::span<const std::byte> values) const {
    static std::atomic<int> count = 0;
    const fs::path file = chunkFile(chunk);
    const fs::path part = fmt::format("{}.{}.{}.part", file.string(), getpid(), ++count);
    const auto bytes = encoded(codec, values, bytesOf(type));
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) {
        throw WriteError("{}: this folder cannot be made ({}); make room, or name another place",
                         file.parent_path().string(), error.message());
    }
    errno = 0;
    std::ofstream stream(part, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    stream.close();
    if (stream) {
        fs::rename(part, file, error);
    }
    if (!stream || error) {
        const std::string why = error ? error.message() : std::strerror(errno == 0 ? EIO : errno);
        fs::remove(part, error);
        throw WriteError("{}: this chunk cannot be written ({}); make room, or name another place",
                         file.string(), why);
    }
}

void ZarrArray::removeChunk(std::span<const std::int64_t> chunk) const {
    std::error_code error;
    fs::remove(chunkFile(chunk), error);
    if (error) {
        throw WriteError("{}: this chunk cannot be removed ({})", chunkFile(chunk).string(), error.message());
    }
}

std::vector<std::byte> ZarrArray::fillValue() const {
    switch (type) {
    case StoredType::UInt8:
        return bytesOfValue<std::uint8_t>(fill);
    case StoredType::Int8:
        return bytesOfValue<std::int8_t>(fill);
    case StoredType::UInt16:
        return bytesOfValue<std::uint16_t>(fill);
    case StoredType::Int16:
        return bytesOfValue<std::int16_t>(fill);
    case StoredType::UInt32:
        return bytesOfValue<std::uint32_t>(fill);
    case StoredType::Int32:
        return bytesOfValue<std::int32_t>(fill);
    case StoredType::UInt64:
        return bytesOfValue<std::uint64_t>(fill);
    case StoredType::Int64:
        return bytesOfValue<std::int64_t>(fill);
    case StoredType::Float32:
        return bytesOfValue<float>(fill);
    case StoredType::Float64:
        break;
    }
    return bytesOfValue<double>(fill);
}

ZarrArray openZarrArray(const fs::path& folder) {
    return readStoreFile(folder / ".zarray", "the description of a Zarr array of version 2",
                         [&](const JsonReader& from) { return readDescription(from, folder); });
}

void createZarrArray(const ZarrArray& array) {
    writeStoreFile(array.folder / ".zarray", {{"zarr_format", 2},
                                              {"shape", array.shape},
                                              {"chunks", array.chunks},
                                              {"dtype", codeOf(array)},
                                              {"compressor", written(array.codec)},
                                              {"fill_value", array.fill},
                                              {"order", "C"},
                                              {"filters", nullptr},
                                              {"dimension_separator", std::string(1, array.separator)}});
}

} // namespace vs::volume
