// SPDX-License-Identifier: Apache-2.0
#include "studio/json/state_file.h"

#include "base/error.h"

#include <zstd.h>

#include <array>
#include <cerrno>

namespace vs::studio {

namespace {

constexpr char kMagic[] = "VSTATE2\n";
constexpr std::size_t kMagicBytes = sizeof(kMagic) - 1;
constexpr std::size_t kTrailerBytes = 2 * sizeof(std::uint64_t);
// Fast: whoever saves waits for it.
constexpr int kLevel = 1;

std::vector<std::byte> wholeFile(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    std::vector<std::byte> bytes(in ? std::size_t(in.tellg()) : 0);
    in.seekg(0);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!in) {
        throw ReadError("{}: cannot be read ({})", path.string(), std::strerror(errno));
    }
    return bytes;
}

} // namespace

// --- writing

StateWriter::StateWriter(const std::filesystem::path& path) : path_(path), out_(path, std::ios::binary) {
    write(std::as_bytes(std::span(kMagic, kMagicBytes)));
}

void StateWriter::write(std::span<const std::byte> bytes) {
    out_.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!out_) {
        throw WriteError("{}: cannot be written ({})", path_.string(), std::strerror(errno));
    }
    at_ += bytes.size();
    hash_.add(bytes);
}

nlohmann::ordered_json StateWriter::block(std::span<const std::byte> bytes) {
    const std::uint64_t begin = at_;
    write(bytes);
    return nlohmann::ordered_json::array({begin, bytes.size()});
}

nlohmann::ordered_json StateWriter::compressed(std::span<const std::byte> bytes) {
    std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
    if (ZSTD_isError(size) != 0U) {
        throw WriteError("{}: could not be compressed: {}; free some memory", path_.string(),
                         ZSTD_getErrorName(size));
    }
    auto place = block(std::span(out).first(size));
    place.push_back(bytes.size());
    return place;
}

std::string StateWriter::finish(const nlohmann::ordered_json& contents) {
    const std::string text = contents.dump();
    const std::array<std::uint64_t, 2> trailer{at_, text.size()};
    write(std::as_bytes(std::span(text)));
    write(std::as_bytes(std::span(trailer)));
    out_.close();
    if (!out_) {
        throw WriteError("{}: cannot be written ({})", path_.string(), std::strerror(errno));
    }
    return hash_.text();
}

// --- reading

StateReader::StateReader(const std::filesystem::path& path) : path_(path), bytes_(wholeFile(path)) {
    if (bytes_.size() < kMagicBytes + kTrailerBytes || std::memcmp(bytes_.data(), kMagic, kMagicBytes) != 0) {
        throw SessionError("{}: is not the state of a session", path.string());
    }
    std::array<std::uint64_t, 2> trailer{};
    std::memcpy(trailer.data(), bytes_.data() + bytes_.size() - kTrailerBytes, kTrailerBytes);
    const std::uint64_t end = bytes_.size() - kTrailerBytes;
    if (trailer[0] > end || trailer[1] != end - trailer[0]) {
        throw SessionError("{}: is cut off or damaged", path.string());
    }
    const auto* text = reinterpret_cast<const char*>(bytes_.data()) + trailer[0];
    try {
        contents_ = nlohmann::ordered_json::parse(text, text + trailer[1]);
    } catch (const nlohmann::ordered_json::exception&) {
        throw SessionError("{}: is damaged: its table of contents is no JSON", path.string());
    }
    Hash64 hash;
    hash.add(std::span<const std::byte>(bytes_));
    checksum_ = hash.text();
}

std::span<const std::byte> StateReader::bytesAt(const JsonReader& place) const {
    const auto most = long(bytes_.size());
    const auto begin = std::size_t(place.at(0).integerBetween(0, most));
    const auto size = std::size_t(place.at(1).integerBetween(0, most - long(begin)));
    return std::span(bytes_).subspan(begin, size);
}

std::vector<std::byte> StateReader::block(const JsonReader& place) const {
    const auto bytes = bytesAt(place);
    return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> StateReader::decompressed(const JsonReader& place, std::size_t mostBytes) const {
    const auto bytes = bytesAt(place);
    const auto size = std::size_t(place.at(2).integerBetween(0, long(mostBytes)));
    std::vector<std::byte> out(size);
    if (ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size()) != size) {
        place.fail("is damaged: it cannot be decompressed");
    }
    return out;
}

} // namespace vs::studio
