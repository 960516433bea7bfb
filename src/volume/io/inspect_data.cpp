// SPDX-License-Identifier: Apache-2.0
// Checks of the values' block: enough bytes, an intact deflate stream of the promised length, enough numbers.
#include "volume/io/inspect.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace vs::volume {
namespace {

enum class StreamEnd { Complete, Early, Corrupt, TooLong, Stopped };

struct InflateResult {
    StreamEnd end = StreamEnd::Early;
    std::uint64_t bytes = 0;
};

// Inflates a zlib or gzip stream (also several members in a row) through a small window and gives each piece
// to `sink`, which returns false to stop. Never holds more than the window, whatever the stream claims.
class Inflater {
public:
    Inflater(std::istream& input, std::uint64_t limit) : input_(input), limit_(limit) {
        inflateInit2(&stream_, 15 + 32); // 15: largest window; +32: detect gzip or zlib
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    InflateResult run(const std::function<bool(const unsigned char*, std::size_t)>& sink) {
        InflateResult result;
        while (true) {
            if (stream_.avail_in == 0 && !refill()) {
                result.end = memberEnded_ ? StreamEnd::Complete : StreamEnd::Early;
                return result;
            }
            if (memberEnded_ && !startNextMember()) {
                result.end = StreamEnd::Complete;
                return result;
            }
            stream_.next_out = out_.data();
            stream_.avail_out = static_cast<uInt>(out_.size());
            const int status = inflate(&stream_, Z_NO_FLUSH);
            const std::size_t made = out_.size() - stream_.avail_out;
            result.bytes += made;
            if (result.bytes > limit_) {
                result.end = StreamEnd::TooLong;
                return result;
            }
            if (made > 0 && !sink(out_.data(), made)) {
                result.end = StreamEnd::Stopped;
                return result;
            }
            if (status == Z_STREAM_END) {
                memberEnded_ = true;
            } else if (status != Z_OK && status != Z_BUF_ERROR) {
                result.end = StreamEnd::Corrupt;
                return result;
            }
        }
    }

private:
    bool refill() {
        input_.read(reinterpret_cast<char*>(in_.data()), static_cast<std::streamsize>(in_.size()));
        stream_.next_in = in_.data();
        stream_.avail_in = static_cast<uInt>(input_.gcount());
        return stream_.avail_in > 0;
    }

    // Zeros after a member are padding (tar, block devices), not another member.
    bool startNextMember() {
        if (*stream_.next_in != 0x1f) {
            return false;
        }
        memberEnded_ = false;
        return inflateReset(&stream_) == Z_OK;
    }

    std::istream& input_;
    std::uint64_t limit_;
    z_stream stream_{};
    bool memberEnded_ = false;
    std::vector<unsigned char> in_ = std::vector<unsigned char>(1 << 16);
    std::vector<unsigned char> out_ = std::vector<unsigned char>(1 << 18);
};

void checkDeflated(const std::filesystem::path& path, const DataBlock& block, std::uint64_t stored) {
    // Deflate shrinks at most by 1032, so a stream that is too small need not be read at all.
    const auto shortOf = [&](std::uint64_t bytes) {
        refuse(
            path,
            fmt::format("its compressed data hold {} bytes, the header promises {}", bytes, block.expected),
            "the file is cut short or its sizes are wrong");
    };
    if (stored > block.expected + (1 << 20) && stored > 2 * block.expected) {
        refuse(path, fmt::format("{} compressed bytes for {} bytes of values", stored, block.expected),
               "the sizes in the header do not fit the data");
    }
    if (stored * 1040 + 1024 < block.expected) {
        refuse(path,
               fmt::format("its {} compressed bytes cannot hold the {} bytes that the header promises",
                           stored, block.expected),
               "the file is cut short or its sizes are wrong");
    }
    std::ifstream input(block.file, std::ios::binary);
    input.seekg(static_cast<std::streamoff>(block.offset));
    const auto result =
        Inflater(input, block.expected).run([](const unsigned char*, std::size_t) { return true; });
    switch (result.end) {
    case StreamEnd::Corrupt:
        refuse(path, "its compressed data are corrupt", "get an intact copy of the file");
    case StreamEnd::Early:
        refuse(
            path,
            fmt::format("its compressed data end early, after {} of {} bytes", result.bytes, block.expected),
            "get a complete copy of the file");
    case StreamEnd::TooLong:
        refuse(path,
               fmt::format("its compressed data expand beyond the {} bytes that the header promises",
                           block.expected),
               "the sizes in the header do not fit the data");
    default:
        break;
    }
    if (result.bytes < block.expected) {
        shortOf(result.bytes);
    }
}

void checkAscii(const std::filesystem::path& path, const DataBlock& block) {
    std::ifstream input(block.file);
    input.seekg(static_cast<std::streamoff>(block.offset));
    std::uint64_t count = 0;
    double value = 0;
    for (std::string word; count < block.expected && input >> word; ++count) {
        if (!parseNumber(word, value)) {
            refuse(path, fmt::format("\"{}\" stands among its values", printable(word)),
                   "text data must be numbers separated by blanks");
        }
    }
    if (count < block.expected) {
        refuse(path, fmt::format("it holds {} numbers, the header promises {}", count, block.expected),
               "the file is cut short or its sizes are wrong");
    }
}

} // namespace

void checkDataBlock(const std::filesystem::path& path, const DataBlock& block,
                    std::vector<std::string>& notices) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(block.file, error);
    if (error || block.offset > size) {
        refuse(path,
               fmt::format("its values should start at byte {}, behind the end of the file", block.offset),
               "the file is cut short or its header is wrong");
    }
    const std::uint64_t stored = size - block.offset;
    if (block.encoding == Encoding::Deflated) {
        checkDeflated(path, block, stored);
        return;
    }
    if (block.encoding == Encoding::Ascii) {
        // Two characters is the least that a number and its separator take.
        if (stored + 1 < block.expected * 2) {
            refuse(path, fmt::format("its {} bytes of text cannot hold {} numbers", stored, block.expected),
                   "the file is cut short or its sizes are wrong");
        }
        checkAscii(path, block);
        return;
    }
    if (stored < block.expected) {
        refuse(path, fmt::format("its values take {} bytes, but only {} are there", block.expected, stored),
               "the file is cut short or its sizes are wrong");
    }
    if (stored > block.expected) {
        notices.push_back(fmt::format("{}: {} bytes behind the values were ignored", path.string(),
                                      stored - block.expected));
    }
}

void readBlock(const DataBlock& block, std::uint64_t skip, std::span<std::byte> out) {
    std::ifstream input(block.file, std::ios::binary);
    if (block.encoding == Encoding::Raw) {
        input.seekg(static_cast<std::streamoff>(block.offset + skip));
        input.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
        if (!input) {
            throw std::runtime_error("the file ended early");
        }
        return;
    }
    input.seekg(static_cast<std::streamoff>(block.offset));
    std::size_t filled = 0;
    Inflater(input, ~std::uint64_t(0)).run([&](const unsigned char* data, std::size_t size) {
        const std::size_t skipped = std::size_t(std::min<std::uint64_t>(skip, size));
        const std::size_t taken = std::min(size - skipped, out.size() - filled);
        skip -= skipped;
        std::memcpy(out.data() + filled, data + skipped, taken);
        filled += taken;
        return filled < out.size();
    });
    if (filled < out.size()) {
        throw std::runtime_error("the compressed data ended early");
    }
}

std::vector<unsigned char> readPrefix(const std::filesystem::path& path, std::size_t count, bool inflated) {
    std::ifstream input(path, std::ios::binary);
    std::vector<unsigned char> prefix;
    if (inflated) {
        Inflater(input, ~std::uint64_t(0)).run([&](const unsigned char* data, std::size_t size) {
            prefix.insert(prefix.end(), data, data + std::min(size, count - prefix.size()));
            return prefix.size() < count;
        });
        return prefix;
    }
    prefix.resize(count);
    input.read(reinterpret_cast<char*>(prefix.data()), static_cast<std::streamsize>(count));
    prefix.resize(static_cast<std::size_t>(input.gcount()));
    return prefix;
}

} // namespace vs::volume
