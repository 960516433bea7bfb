// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/brick_codec.h"

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace vs::sculpt {
namespace {

using Bytes = std::vector<std::byte>;

std::size_t differences(const Bytes& a, const Bytes& b, std::size_t texelBytes) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.size(); n += texelBytes) {
        count += std::memcmp(&a[n], &b[n], texelBytes) != 0 ? 1 : 0;
    }
    return count;
}

Bytes noise(std::size_t size, unsigned seed) {
    std::mt19937 random(seed);
    Bytes bytes(size);
    for (auto& byte : bytes) {
        byte = std::byte(random() & 0xffU);
    }
    return bytes;
}

TEST(BrickCodec, AnyBytesComeBack) {
    const glm::ivec3 sizes[] = {{32, 32, 32}, {5, 7, 3}, {1, 1, 1}, {32, 9, 1}, {8, 1, 16}};
    for (const std::size_t texelBytes : {1U, 2U, 4U}) {
        BrickEncoder encoder(texelBytes);
        std::vector<std::pair<Bytes, Bytes>> bricks; // held, current
        std::mt19937 random(7);
        for (const glm::ivec3 size : sizes) {
            const std::size_t texels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
            Bytes held = noise(texels * texelBytes, unsigned(texels));
            Bytes current = held;
            for (std::size_t n = 0; n < texels; ++n) { // a third of the texels differ, in all or some bytes
                if (random() % 3 == 0) {
                    current[n * texelBytes + random() % texelBytes] ^= std::byte(1U + random() % 255U);
                }
            }
            EXPECT_EQ(encoder.add(size, held, current), differences(held, current, texelBytes));
            bricks.emplace_back(held, current);
        }
        const Bytes encoded = encoder.finish();
        BrickDecoder decoder(texelBytes, encoded);
        for (std::size_t n = 0; n < bricks.size(); ++n) {
            Bytes texels = bricks[n].second;
            decoder.next(sizes[n], texels);
            ASSERT_EQ(texels, bricks[n].first) << texelBytes << " bytes, brick " << n;
        }
    }
}

// A smooth cut face in half floats, seen from the side that has it and from the one that has not.
TEST(BrickCodec, SmoothFacesTakeFewBytes) {
    const glm::ivec3 size(32);
    Bytes cut(32 * 32 * 32 * 2);
    std::size_t n = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, n += 2) {
                const double depth = 20 - glm::length(glm::dvec3(x, y, z) - glm::dvec3(16, 14, -2));
                const double value = 0.5 + 0.5 * std::erf(depth / std::sqrt(2.0));
                const glm::uint16 half = glm::packHalf1x16(value > 1.0 / 2048 ? float(value) : 0.0F);
                std::memcpy(&cut[n], &half, 2);
            }
        }
    }
    const Bytes whole(cut.size());
    BrickEncoder undo(2);
    const std::size_t changed = undo.add(size, whole, cut);
    EXPECT_LT(undo.finish().size(), changed / 10);
    BrickEncoder redo(2);
    redo.add(size, cut, whole);
    EXPECT_LT(redo.finish().size(), changed);
}

} // namespace
} // namespace vs::sculpt
