// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace vs::phantom {

// 64 bits that look random, a function of `counter` alone (Steele, Lea and Flood 2014, "Fast splittable
// pseudorandom number generators"): any voxel's numbers can be had in any order, by any thread.
inline std::uint64_t randomBits(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

// Two independent numbers of the normal distribution with variance 1 (Box and Muller 1958), always the same
// for one seed and counter.
inline glm::dvec2 normalPair(std::uint64_t seed, std::uint64_t counter) {
    constexpr double kUnit = 1.0 / 9007199254740992.0; // 2^-53
    const std::uint64_t base = randomBits(seed) + 2 * counter;
    const double radius = std::sqrt(-2 * std::log((double(randomBits(base) >> 11) + 0.5) * kUnit));
    const double angle = 2 * std::numbers::pi * (double(randomBits(base + 1) >> 11) * kUnit);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

} // namespace vs::phantom
