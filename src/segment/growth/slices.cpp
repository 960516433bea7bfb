// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/slices.h"

namespace vs::segment::slices {

namespace {

// The four words of two slices: x fastest, then y, so word 0 and 2 hold the left half's rows.
struct Halves {
    std::uint32_t left = 0;
    std::uint32_t right = 0;
};

Halves halvesOf(std::uint64_t slice) { return {leftHalf(slice), leftHalf(slice >> 4U)}; }

} // namespace

Slices fromWords(const std::uint32_t* words) {
    Slices s;
    for (std::size_t pair = 0; pair < 4; ++pair, words += 4) {
        const std::uint32_t lowLeft = (words[0] & 0xffffU) | words[2] << 16U;
        const std::uint32_t lowRight = (words[1] & 0xffffU) | words[3] << 16U;
        const std::uint32_t highLeft = words[0] >> 16U | (words[2] & 0xffff0000U);
        const std::uint32_t highRight = words[1] >> 16U | (words[3] & 0xffff0000U);
        s.z[2 * pair] = fromLeftHalf(lowLeft) | fromLeftHalf(lowRight) << 4U;
        s.z[2 * pair + 1] = fromLeftHalf(highLeft) | fromLeftHalf(highRight) << 4U;
    }
    return s;
}

void joinWords(const Slices& s, std::uint32_t* words) {
    for (std::size_t pair = 0; pair < 4; ++pair, words += 4) {
        const Halves low = halvesOf(s.z[2 * pair]);
        const Halves high = halvesOf(s.z[2 * pair + 1]);
        words[0] |= (low.left & 0xffffU) | high.left << 16U;
        words[1] |= (low.right & 0xffffU) | high.right << 16U;
        words[2] |= low.left >> 16U | (high.left & 0xffff0000U);
        words[3] |= low.right >> 16U | (high.right & 0xffff0000U);
    }
}

} // namespace vs::segment::slices
