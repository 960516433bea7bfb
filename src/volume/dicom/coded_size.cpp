// SPDX-License-Identifier: Apache-2.0
#include "volume/dicom/coded_size.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace vs::volume {
namespace {

using Bytes = std::span<const unsigned char>;

// A number of `width` bytes, the highest first; 0 beyond the end.
std::uint64_t numberAt(Bytes bytes, std::size_t at, std::size_t width) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < width; ++i) {
        number = number << 8 | (at + i < bytes.size() ? bytes[at + i] : 0U);
    }
    return number;
}

glm::ivec2 sizeOf(std::uint64_t columns, std::uint64_t rows) {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    return {int(std::min(columns, most)), int(std::min(rows, most))};
}

// SIZ: the reference grid's size, then where the image begins in it.
std::optional<glm::ivec2> jpeg2000Size(Bytes stream) {
    constexpr std::size_t whole = 24;
    if (stream.size() < whole) {
        return {};
    }
    const std::uint64_t right = numberAt(stream, 8, 4);
    const std::uint64_t bottom = numberAt(stream, 12, 4);
    const std::uint64_t left = numberAt(stream, 16, 4);
    const std::uint64_t top = numberAt(stream, 20, 4);
    return left > right || top > bottom ? std::nullopt : std::optional(sizeOf(right - left, bottom - top));
}

// A stream of marked segments, among which one of the frame headers (SOF) stands.
std::optional<glm::ivec2> jpegSize(Bytes stream) {
    constexpr std::array<unsigned char, 14> frames{0xC0, 0xC1, 0xC2, 0xC3, 0xC5, 0xC6, 0xC7,
                                                   0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF, 0xF7};
    std::size_t at = 2;
    while (at + 9 < stream.size() && stream[at] == 0xFF) {
        const unsigned char mark = stream[at + 1];
        if (mark == 0xFF) { // padding before a mark
            ++at;
        } else if (std::find(frames.begin(), frames.end(), mark) != frames.end()) {
            return sizeOf(numberAt(stream, at + 7, 2), numberAt(stream, at + 5, 2));
        } else {
            at += 2 + std::size_t(numberAt(stream, at + 2, 2));
        }
    }
    return {};
}

// Where runs (PackBits) end that make as many bytes, or a few more: some programs fill segments up. Nothing
// where they make others.
std::optional<std::vector<bool>> endsOfRuns(Bytes runs, std::size_t wanted) {
    constexpr std::size_t mostMore = 8;
    std::vector<bool> ends(wanted + 1);
    std::size_t made = 0;
    for (std::size_t at = 0; at < runs.size() && made <= wanted + mostMore;) {
        const auto head = static_cast<signed char>(runs[at]);
        const std::size_t count = head == -128 ? 0
                                  : head >= 0  ? 1 + std::size_t(head)
                                               : std::size_t(1 - head);
        at += head == -128 ? 1 : head >= 0 ? 1 + count : 2;
        if (at > runs.size()) {
            break; // cut off: what fills up
        }
        made += count;
        if (made <= wanted) {
            ends[made] = true;
        }
    }
    return made >= wanted && made <= wanted + mostMore ? std::optional(std::move(ends)) : std::nullopt;
}

// Whether runs end with every row of so many pixels, as the standard wants it.
bool endWithRows(const std::vector<bool>& ends, std::size_t columns) {
    for (std::size_t i = columns; i < ends.size(); i += columns) {
        if (!ends[i]) {
            return false;
        }
    }
    return true;
}

// Whether the rows are others than those of so many columns: some programs end runs anywhere, which tells
// nothing, but where they end with all rows of another length, that is the image's.
bool haveOtherRows(const std::vector<bool>& ends, std::size_t columns) {
    constexpr std::size_t fewest = 4;    // rows or columns that are no chance
    constexpr std::size_t longest = 128; // runs of an even image end where they cannot be longer
    const std::size_t pixels = ends.size() - 1;
    bool areLongest = true;
    for (std::size_t i = 1; i < pixels; ++i) {
        areLongest = areLongest && (!ends[i] || i % longest == 0);
    }
    if (areLongest || endWithRows(ends, columns)) {
        return false;
    }
    for (std::size_t other = fewest; other * fewest <= pixels; ++other) {
        if (pixels % other == 0 && endWithRows(ends, other)) {
            return true;
        }
    }
    return false;
}

// As DICOM has numbers in this header: the lowest byte first.
std::size_t littleAt(Bytes bytes, std::size_t at) {
    return std::size_t(bytes[at]) | std::size_t(bytes[at + 1]) << 8 | std::size_t(bytes[at + 2]) << 16 |
           std::size_t(bytes[at + 3]) << 24;
}

} // namespace

std::optional<glm::ivec2> codedSize(std::span<const unsigned char> frame) {
    // JPEG 2000 may lie in the boxes of its file format (JP2).
    constexpr std::array<unsigned char, 4> codestream{0xFF, 0x4F, 0xFF, 0x51};
    constexpr std::size_t farthest = 4096;
    const auto end = frame.begin() + std::ptrdiff_t(std::min(frame.size(), farthest));
    const auto found = std::search(frame.begin(), end, codestream.begin(), codestream.end());
    const bool isBoxed = frame.size() > 12 && numberAt(frame, 4, 4) == 0x6A502020; // "jP  "
    if (found != end && (found == frame.begin() || isBoxed)) {
        return jpeg2000Size(frame.subspan(std::size_t(found - frame.begin())));
    }
    return frame.size() > 2 && frame[0] == 0xFF && frame[1] == 0xD8 ? jpegSize(frame) : std::nullopt;
}

bool isRunLengthOf(std::span<const unsigned char> frame, glm::ivec2 size, std::size_t bytesEach) {
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    constexpr std::size_t headBytes = 64;
    constexpr std::size_t most = 15;
    if (frame.size() < headBytes) {
        return false;
    }
    const std::size_t segments = littleAt(frame, 0);
    if (segments != bytesEach || segments > most) {
        return false;
    }
    for (std::size_t i = 0; i < segments; ++i) {
        const std::size_t begin = littleAt(frame, 4 + 4 * i);
        const std::size_t end = i + 1 < segments ? littleAt(frame, 8 + 4 * i) : frame.size();
        if (begin < headBytes || begin > end || end > frame.size()) {
            return false;
        }
        const auto ends = endsOfRuns(frame.subspan(begin, end - begin), pixels);
        if (!ends || haveOtherRows(*ends, std::size_t(size.x))) {
            return false;
        }
    }
    return true;
}

bool isRunLengthSyntax(std::string_view uid) { return uid == "1.2.840.10008.1.2.5"; }

bool isJpegSyntax(std::string_view uid) {
    constexpr std::string_view family = "1.2.840.10008.1.2.4.";
    return uid.starts_with(family) && uid.size() == family.size() + 2;
}

} // namespace vs::volume
