// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/brick_codec.h"

#include "base/check.h"
#include "base/error.h"
#include "base/math.h"

#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace vs::sculpt {

namespace {

// Fast rather than small: undo must not be felt.
constexpr int kCompressionLevel = 1;

// The most that a stream of one encoding can have: 16 bricks of 32^3 texels, a byte each.
constexpr std::size_t kMostBytes = std::size_t(16) * 32 * 32 * 32;

void appendNumber(std::vector<std::byte>& out, std::uint32_t number) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&number);
    out.insert(out.end(), bytes, bytes + sizeof(number));
}

// Contents may come from a file (BrickDelta::from).
void expect(bool isRight) {
    if (!isRight) {
        throw Error("a change of the sculpture that was kept is damaged");
    }
}

std::uint32_t takeNumber(std::span<const std::byte>& in) {
    std::uint32_t number = 0;
    expect(in.size() >= sizeof(number));
    std::memcpy(&number, in.data(), sizeof(number));
    in = in.subspan(sizeof(number));
    return number;
}

// A stream: its length before and after compression, then the compressed bytes.
void appendStream(std::vector<std::byte>& out, const std::vector<std::byte>& bytes) {
    std::vector<std::byte> compressed(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(compressed.data(), compressed.size(), bytes.data(), bytes.size(), kCompressionLevel);
    if (ZSTD_isError(size) != 0U) {
        throw Error("undo data could not be compressed: {}; free some memory", ZSTD_getErrorName(size));
    }
    appendNumber(out, std::uint32_t(bytes.size()));
    appendNumber(out, std::uint32_t(size));
    out.insert(out.end(), compressed.begin(), compressed.begin() + std::ptrdiff_t(size));
}

std::vector<std::byte> takeStream(std::span<const std::byte>& in) {
    const std::size_t whole = takeNumber(in);
    const std::size_t compressed = takeNumber(in);
    expect(compressed <= in.size() && ZSTD_getFrameContentSize(in.data(), compressed) == whole &&
           whole <= kMostBytes);
    std::vector<std::byte> bytes(whole);
    expect(ZSTD_decompress(bytes.data(), bytes.size(), in.data(), compressed) == whole);
    in = in.subspan(compressed);
    return bytes;
}

// The texels of one brick as integers, with a border of zeros on the lower sides: where a neighbour is
// missing the prediction does without that axis.
class Codes {
public:
    explicit Codes(glm::ivec3 size)
        : row_(std::size_t(size.x) + 1), slice_(row_ * (std::size_t(size.y) + 1)),
          codes_(slice_ * (std::size_t(size.z) + 1), 0) {}

    std::uint32_t& at(int x, int y, int z) {
        return codes_[std::size_t(z + 1) * slice_ + std::size_t(y + 1) * row_ + std::size_t(x + 1)];
    }
    // What the seven neighbours on the lower sides tell: right where the texels are a sum of functions of two
    // coordinates each.
    [[nodiscard]] std::uint32_t predict(int x, int y, int z) const {
        const std::uint32_t* here =
            &codes_[std::size_t(z + 1) * slice_ + std::size_t(y + 1) * row_ + std::size_t(x + 1)];
        const auto before = [here](std::size_t offset) { return std::int64_t(*(here - offset)); };
        return std::uint32_t(before(1) + before(row_) + before(slice_) - before(1 + row_) -
                             before(1 + slice_) - before(row_ + slice_) + before(1 + row_ + slice_));
    }

private:
    std::size_t row_;
    std::size_t slice_;
    std::vector<std::uint32_t> codes_;
};

// Reads texels of one, two or four bytes as integers, a row at a time.
template <typename Texel>
void loadRow(const std::byte* from, std::uint32_t* to, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
        Texel texel = 0;
        std::memcpy(&texel, from + n * sizeof(Texel), sizeof(Texel));
        to[n] = texel;
    }
}

void loadRow(std::span<const std::byte> texels, std::size_t first, std::size_t texelBytes, std::uint32_t* to,
             std::size_t count) {
    const std::byte* from = texels.data() + first * texelBytes;
    if (texelBytes == 1) {
        loadRow<std::uint8_t>(from, to, count);
    } else if (texelBytes == 2) {
        loadRow<std::uint16_t>(from, to, count);
    } else {
        loadRow<std::uint32_t>(from, to, count);
    }
}

// Differences of either sign, modulo the texel's size, as small numbers: 0, -1, 1, -2, ...
std::uint32_t folded(std::uint32_t difference, unsigned shift) {
    const auto wide = std::int32_t(difference << shift) >> shift; // sign extended
    return (std::uint32_t(wide) << 1U) ^ std::uint32_t(wide >> 31);
}

std::uint32_t unfolded(std::uint32_t number) { return (number >> 1U) ^ (0U - (number & 1U)); }

std::size_t texelsOf(glm::ivec3 size) {
    const Box3 box{glm::ivec3(0), size};
    return box.volume();
}

std::size_t rowBytes(glm::ivec3 size) { return std::size_t(divideUp(size.x, 8)); }

} // namespace

BrickEncoder::BrickEncoder(std::size_t texelBytes) : texelBytes_(texelBytes) {
    VS_CHECK(texelBytes == 1 || texelBytes == 2 || texelBytes == 4);
}

std::size_t BrickEncoder::add(glm::ivec3 size, std::span<const std::byte> held,
                              std::span<const std::byte> current) {
    VS_CHECK_EQ(held.size(), texelsOf(size) * texelBytes_);
    VS_CHECK_EQ(current.size(), held.size());
    const auto shift = unsigned(32 - 8 * texelBytes_);
    const std::uint32_t most = 0xffffffffU >> shift;
    const std::size_t before = planes_[0].size();
    const auto width = std::size_t(size.x);
    Codes codes(size);
    std::vector<std::uint32_t> other(width);
    std::size_t n = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y, n += width) {
            const std::size_t row = changed_.size();
            changed_.resize(row + rowBytes(size), std::byte(0));
            std::uint32_t* own = &codes.at(0, y, z);
            loadRow(held, n, texelBytes_, own, width);
            loadRow(current, n, texelBytes_, other.data(), width);
            for (std::size_t x = 0; x < width; ++x) {
                if (own[x] == other[x]) {
                    continue;
                }
                changed_[row + x / 8] |= std::byte(1U << (x % 8));
                const std::uint32_t missed = folded((own[x] - codes.predict(int(x), y, z)) & most, shift);
                for (std::size_t plane = 0; plane < texelBytes_; ++plane) {
                    planes_[plane].push_back(std::byte((missed >> (8 * plane)) & 0xffU));
                }
            }
        }
    }
    return planes_[0].size() - before;
}

std::vector<std::byte> BrickEncoder::finish() const {
    std::vector<std::byte> out;
    appendStream(out, changed_);
    for (std::size_t plane = 0; plane < texelBytes_; ++plane) {
        appendStream(out, planes_[plane]);
    }
    return out;
}

BrickDecoder::BrickDecoder(std::size_t texelBytes, std::span<const std::byte> encoded)
    : texelBytes_(texelBytes), changed_(takeStream(encoded)) {
    for (std::size_t plane = 0; plane < texelBytes_; ++plane) {
        planes_[plane] = takeStream(encoded);
    }
}

void BrickDecoder::next(glm::ivec3 size, std::span<std::byte> texels) {
    VS_CHECK_EQ(texels.size(), texelsOf(size) * texelBytes_);
    const std::uint32_t most = 0xffffffffU >> unsigned(32 - 8 * texelBytes_);
    const auto width = std::size_t(size.x);
    Codes codes(size);
    std::size_t n = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y, n += width) {
            expect(changedAt_ + rowBytes(size) <= changed_.size());
            const std::byte* row = &changed_[changedAt_];
            changedAt_ += rowBytes(size);
            std::uint32_t* own = &codes.at(0, y, z);
            loadRow(texels, n, texelBytes_, own, width);
            for (std::size_t x = 0; x < width; ++x) {
                if ((row[x / 8] & std::byte(1U << (x % 8))) == std::byte(0)) {
                    continue;
                }
                std::uint32_t missed = 0;
                for (std::size_t plane = 0; plane < texelBytes_; ++plane) {
                    expect(planeAt_ < planes_[plane].size());
                    missed |= std::uint32_t(planes_[plane][planeAt_]) << (8 * plane);
                }
                ++planeAt_;
                own[x] = (codes.predict(int(x), y, z) + unfolded(missed)) & most;
                std::memcpy(&texels[(n + x) * texelBytes_], &own[x], texelBytes_);
            }
        }
    }
}

} // namespace vs::sculpt
