// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "phantom/scanner.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace vs::phantom {

enum class Kind { Head, Body, Vessels, Abdomen, Skull };
inline constexpr std::array<const char*, 5> kKinds{"head", "body", "vessels", "abdomen", "skull"};
constexpr const auto& namesOf(Kind) { return kKinds; }

inline constexpr int kLeastVoxels = 8;          // along each axis
inline constexpr int kMostVoxels = 2048;        // of one that is in memory
inline constexpr int kMostStoredVoxels = 16384; // of one that is written box by box

// Which phantom to make, and what it is measured with: what a command line or a session says of it.
struct Recipe {
    static constexpr const char* kName = "phantom";

    Kind kind = Kind::Head;
    std::optional<glm::ivec3> dims = {}; // its own if not set
    double noisePercent = 0;
    double biasPercent = 0; // only of kinds that have a bias
    int seed = 1;

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("phantom", &Recipe::kind, {}, "a volume that is made, whose tissues are known"),
            sparse("dims", &Recipe::dims, {.least = kLeastVoxels, .most = kMostVoxels, .unit = "voxels"}),
            sparse("noise", &Recipe::noisePercent, {.least = 0, .most = 100}, "percent"),
            sparse("bias", &Recipe::biasPercent, {.least = 0, .most = 100},
                   "percent; of the head: how much the sensitivity varies"),
            sparse("seed", &Recipe::seed, {.least = 0, .most = 1 << 30}, "of the noise")};
    }
    bool operator==(const Recipe&) const = default;
};

// What there is to know of a kind.
struct About {
    const char* meaning; // "T1-weighted MR of a head, uint8"
    glm::ivec3 dims;     // if none are given
    bool hasBias;
    const char* noiseOf;                  // what the noise is a percentage of
    std::span<const char* const> tissues; // what each label stands for, from 0
    Scanner (*scanner)(const Recipe& recipe);
};
const About& about(Kind kind);

// Makes it box by box, or all of it. Both throw UsageError for a bias where there is none.
Scanner scannerOf(const Recipe& recipe);
LabelledVolume make(const Recipe& recipe);

} // namespace vs::phantom
