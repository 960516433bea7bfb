// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpture/brick_codec.h"

#include "property.h"

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

// Texels that an edit has changed: `held` is what was there before.
struct Brick {
    glm::ivec3 size;
    Bytes held;
    Bytes current;
};

void showValue(const Brick& brick, std::ostream& out) {
    out << brick.size.x << " x " << brick.size.y << " x " << brick.size.z << " texels; changed bytes:";
    for (std::size_t n = 0; n < brick.held.size(); ++n) {
        if (brick.held[n] != brick.current[n]) {
            out << ' ' << n << " (" << int(brick.held[n]) << " to " << int(brick.current[n]) << ')';
        }
    }
}

// Up to a third of the texels differ, in one byte each time that one is chosen.
rc::Gen<Brick> anyBrick(std::size_t texelBytes) {
    return rc::gen::exec([texelBytes] {
        const auto side = [] {
            return *rc::gen::oneOf(rc::gen::map(test::below(32), [](int n) { return 1 + n; }),
                                   rc::gen::element(1, 8, 32));
        };
        Brick brick{{side(), side(), side()}, {}, {}};
        const int bytes = brick.size.x * brick.size.y * brick.size.z * int(texelBytes);
        brick.held = noise(std::size_t(bytes), unsigned(bytes));
        brick.current = brick.held;
        const auto change =
            rc::gen::pair(test::below(bytes), rc::gen::map(test::below(255), [](int n) { return 1 + n; }));
        for (const auto& [place, bits] : *test::upTo(bytes / 3 / int(texelBytes), change)) {
            brick.current[std::size_t(place)] ^= std::byte(bits);
        }
        return brick;
    });
}

TEST(BrickCodec, AnyBytesComeBack) {
    for (const std::size_t texelBytes : {1U, 2U, 4U}) {
        test::checkProperty(5, [texelBytes] {
            BrickEncoder encoder(texelBytes);
            const auto bricks = *test::upTo(6, anyBrick(texelBytes));
            for (const Brick& brick : bricks) {
                RC_ASSERT(encoder.add(brick.size, brick.held, brick.current) ==
                          differences(brick.held, brick.current, texelBytes));
            }
            const Bytes encoded = encoder.finish();
            BrickDecoder decoder(texelBytes, encoded);
            for (const Brick& brick : bricks) {
                Bytes texels = brick.current;
                decoder.next(brick.size, texels);
                RC_ASSERT((texels == brick.held));
            }
        });
    }
}

// A smooth cut face in half floats, seen from the side that has it and from the one that has not.
TEST(BrickCodec, SmoothFacesTakeFewBytes) {
    const glm::ivec3 size(32);
    Bytes cut(std::size_t(32) * 32 * 32 * 2);
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
