// SPDX-License-Identifier: Apache-2.0
// Checks of the values' block: enough bytes, an intact deflate stream of the promised length, enough numbers.
#include "volume/io/inspect.h"

#include "base/large_pages.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

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
    // Reads at most `mostStored` bytes and makes at most `limit`, so many of them at a time.
    Inflater(std::istream& input, std::uint64_t mostStored, std::uint64_t limit,
             std::size_t window = std::size_t(1) << 18)
        : input_(input), left_(mostStored), limit_(limit), out_(window) {
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
        const auto most = std::min<std::uint64_t>(left_, in_.size());
        input_.read(reinterpret_cast<char*>(in_.data()), static_cast<std::streamsize>(most));
        left_ -= std::uint64_t(input_.gcount());
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
    std::uint64_t left_;
    std::uint64_t limit_;
    z_stream stream_{};
    bool memberEnded_ = false;
    std::vector<unsigned char> in_ = std::vector<unsigned char>(1 << 16);
    std::vector<unsigned char> out_;
};

// A number of text, as a value of a type: whole and within its range where that is one of integers, so that
// nothing is lost by taking it.
template <typename T>
bool takeNumber(const std::string& word, T& value) {
    if constexpr (std::is_integral_v<T>) {
        const char* const end = word.data() + word.size();
        const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
        if (const auto [last, fault] = std::from_chars(begin, end, value);
            fault == std::errc() && last == end) {
            return true;
        }
        // Some programs write "12.0" or "1e3".
        double number = 0;
        if (!parseNumber(word, number) || number != std::floor(number) || !(std::abs(number) < 9e15) ||
            number < double(std::numeric_limits<T>::lowest()) ||
            number > double(std::numeric_limits<T>::max())) {
            return false;
        }
        value = T(number);
        return true;
    } else {
        double number = 0;
        const bool isNumber = parseNumber(word, number);
        value = T(number);
        // What is written as a number has to stay one.
        return isNumber && (std::isfinite(value) || !std::isfinite(number));
    }
}

// Calls work(word, isNumber, value) for the numbers of a block of text, up to as many as it promises and
// while that returns true.
template <typename T, typename Work>
void forEachNumber(const DataBlock& block, Work work) {
    std::ifstream input(block.file);
    input.seekg(static_cast<std::streamoff>(block.offset));
    std::string word;
    for (std::uint64_t i = 0; i < block.count && input >> word; ++i) {
        T value{};
        const bool isNumber = takeNumber(word, value);
        if (!work(word, isNumber, value)) {
            return;
        }
    }
}

// In the order of StoredType.
using StoredTypes = std::tuple<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t,
                               std::int32_t, std::uint64_t, std::int64_t, float, double>;

// Calls work with a value of the type.
template <typename Work>
void withType(StoredType type, Work work) {
    const auto index = std::size_t(type);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((I == index ? work(std::tuple_element_t<I, StoredTypes>()) : void()), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<StoredTypes>>());
}

void checkDeflated(const std::filesystem::path& path, DataBlock& block, std::uint64_t stored,
                   Inflated inflated) {
    const std::uint64_t expected = block.bytes();
    // Deflate shrinks at most by 1032, so a stream that is too small need not be read at all.
    const auto shortOf = [&](std::uint64_t bytes) {
        refuse(path,
               fmt::format("its compressed data hold {} bytes, the header promises {}", bytes, expected),
               "the file is cut short or its sizes are wrong");
    };
    if (stored > expected + (1 << 20) && stored > 2 * expected) {
        refuse(path, fmt::format("{} compressed bytes for {} bytes of values", stored, expected),
               "the sizes in the header do not fit the data");
    }
    if (stored * 1040 + 1024 < expected) {
        refuse(path,
               fmt::format("its {} compressed bytes cannot hold the {} bytes that the header promises",
                           stored, expected),
               "the file is cut short or its sizes are wrong");
    }
    std::uint64_t before = block.before;
    if (inflated == Inflated::Kept) {
        block.inflated = std::make_shared<std::vector<std::byte>>();
        reserveInLargePages(*block.inflated,
                            expected - before); // no more than a thousand times what is stored
    }
    std::ifstream input(block.file, std::ios::binary);
    input.seekg(static_cast<std::streamoff>(block.offset));
    const auto result =
        Inflater(input, stored, expected).run([&](const unsigned char* data, std::size_t size) {
            if (block.inflated) {
                const auto dropped = std::size_t(std::min<std::uint64_t>(before, size));
                const auto* bytes = reinterpret_cast<const std::byte*>(data);
                block.inflated->insert(block.inflated->end(), bytes + dropped, bytes + size);
                before -= dropped;
            }
            return true;
        });
    switch (result.end) {
    case StreamEnd::Corrupt:
        refuse(path, "its compressed data are corrupt", "get an intact copy of the file");
    case StreamEnd::Early:
        refuse(path,
               fmt::format("its compressed data end early, after {} of {} bytes", result.bytes, expected),
               "get a complete copy of the file");
    case StreamEnd::TooLong:
        refuse(
            path,
            fmt::format("its compressed data expand beyond the {} bytes that the header promises", expected),
            "the sizes in the header do not fit the data");
    default:
        break;
    }
    if (result.bytes < expected) {
        shortOf(result.bytes);
    }
}

void checkAscii(const std::filesystem::path& path, const DataBlock& block) {
    std::uint64_t count = 0;
    withType(block.type, [&](auto example) {
        using T = decltype(example);
        forEachNumber<T>(block, [&](const std::string& word, bool isNumber, T) {
            double number = 0;
            if (!isNumber) {
                refuse(path, fmt::format("\"{}\" stands among its values", printable(word)),
                       parseNumber(word, number) ? "every value must be one of its type"
                                                 : "text data must be numbers separated by blanks");
            }
            ++count;
            return true;
        });
    });
    if (count < block.count) {
        refuse(path, fmt::format("it holds {} numbers, the header promises {}", count, block.count),
               "the file is cut short or its sizes are wrong");
    }
}

std::vector<std::byte> readAscii(const DataBlock& block, std::uint64_t skip, std::uint64_t count) {
    std::vector<std::byte> bytes(count * bytesOf(block.type));
    std::uint64_t at = 0;
    withType(block.type, [&](auto example) {
        using T = decltype(example);
        forEachNumber<T>(block, [&](const std::string&, bool, T value) {
            if (at >= skip) {
                std::memcpy(bytes.data() + (at - skip) * sizeof(T), &value, sizeof(T));
            }
            ++at;
            return at < skip + count;
        });
    });
    if (at < skip + count) {
        throw std::runtime_error("the file ended early");
    }
    return bytes;
}

// Reads bytes of a block behind the first `skip`.
void readBytes(const DataBlock& block, std::uint64_t skip, std::span<std::byte> out) {
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
    constexpr auto all = ~std::uint64_t(0);
    Inflater(input, block.mostStored > 0 ? block.mostStored : all, all)
        .run([&](const unsigned char* data, std::size_t size) {
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

void swapBytes(std::vector<std::byte>& bytes, std::size_t width) {
    for (std::size_t i = 0; width > 1 && i < bytes.size(); i += width) {
        std::reverse(bytes.data() + i, bytes.data() + i + width);
    }
}

} // namespace

std::uint64_t bytesOf(StoredType type) {
    constexpr std::array<std::uint64_t, 10> bytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return bytes[std::size_t(type)];
}

void checkDataBlock(const std::filesystem::path& path, DataBlock& block, std::vector<std::string>& notices,
                    Inflated inflated) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(block.file, error);
    if (error || block.offset > size) {
        refuse(path,
               fmt::format("its values should start at byte {}, behind the end of the file", block.offset),
               "the file is cut short or its header is wrong");
    }
    const std::uint64_t there = size - block.offset;
    if (block.mostStored > there) {
        refuse(path,
               fmt::format("its values should take {} bytes, but only {} are there", block.mostStored, there),
               "the file is cut short or its header is wrong");
    }
    const std::uint64_t stored = block.mostStored > 0 ? block.mostStored : there;
    if (block.encoding == Encoding::Deflated) {
        checkDeflated(path, block, stored, inflated);
        return;
    }
    if (block.encoding == Encoding::Ascii) {
        // Two characters is the least that a number and its separator take.
        if (stored + 1 < block.count * 2) {
            refuse(path, fmt::format("its {} bytes of text cannot hold {} numbers", stored, block.count),
                   "the file is cut short or its sizes are wrong");
        }
        checkAscii(path, block);
        return;
    }
    if (stored < block.bytes()) {
        refuse(path, fmt::format("its values take {} bytes, but only {} are there", block.bytes(), stored),
               "the file is cut short or its sizes are wrong");
    }
    if (stored > block.bytes()) {
        notices.push_back(fmt::format("{}: {} bytes behind the values were ignored", path.string(),
                                      stored - block.bytes()));
    }
}

std::vector<std::byte> readValues(DataBlock& block, std::uint64_t skip, std::uint64_t count) {
    if (block.encoding == Encoding::Ascii) {
        return readAscii(block, skip, count);
    }
    const std::uint64_t width = bytesOf(block.type);
    std::vector<std::byte> bytes;
    if (block.inflated) {
        bytes = std::move(*block.inflated);
        block.inflated.reset();
        bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(skip * width));
        bytes.resize(count * width);
    } else {
        reserveInLargePages(bytes, count * width);
        bytes.resize(count * width);
        readBytes(block, block.before + skip * width, bytes);
    }
    if (block.isBigEndian != (std::endian::native == std::endian::big)) {
        swapBytes(bytes, width);
    }
    return bytes;
}

std::vector<unsigned char> inflatedPrefix(const std::filesystem::path& path, std::size_t count) {
    std::ifstream input(path, std::ios::binary);
    std::vector<unsigned char> prefix;
    Inflater(input, ~std::uint64_t(0), ~std::uint64_t(0), std::max<std::size_t>(1, count))
        .run([&](const unsigned char* data, std::size_t size) {
            prefix.insert(prefix.end(), data, data + std::min(size, count - prefix.size()));
            return prefix.size() < count;
        });
    return prefix;
}

} // namespace vs::volume
