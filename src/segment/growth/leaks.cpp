// SPDX-License-Identifier: Apache-2.0
#include "segment/growth/leaks.h"

#include <algorithm>
#include <numeric>

namespace vs::segment {

namespace {

constexpr double kJump = 2;       // as many voxels as are expected
constexpr double kSteepest = 0.6; // that a rate is expected to fall
constexpr double kGain = 0.2;     // of the region before
constexpr int kShortest = 3;      // generations that a rate is the mean of
constexpr int kPartOfAge = 8;
constexpr std::size_t kMost = 3;

struct Leak {
    int generation = 0;
    double jump = 0;
};

// Voxels grown up to each generation, and by how much its rates exceed what is expected.
class Rates {
public:
    Rates(std::span<const std::uint64_t> voxels, int begun) : begun_(begun), total_(voxels.size() + 1, 0) {
        std::inclusive_scan(voxels.begin(), voxels.end(), total_.begin() + 1);
    }

    [[nodiscard]] int last() const { return int(total_.size()) - 1; }
    // 0 where nothing can be said.
    [[nodiscard]] double jumpAfter(int generation) const {
        const int age = generation - begun_;
        const int span = std::max(kShortest, age / kPartOfAge);
        if (age < 2 * span || generation + span > last() || !isWorthIt(generation)) {
            return 0;
        }
        const double before = mean(generation - span, generation);
        const double sides = (age + 0.5 * span) / (age - 0.5 * span); // of a freely spreading front
        const double trend = before / mean(generation - 2 * span, generation - span);
        const double growth = std::clamp(trend, kSteepest, sides * sides);
        return mean(generation, generation + span) / (before * growth);
    }

private:
    [[nodiscard]] double upTo(int generation) const { return double(total_[std::size_t(generation)]); }
    [[nodiscard]] double mean(int after, int upToThis) const {
        return std::max(1.0, (upTo(upToThis) - upTo(after)) / (upToThis - after));
    }
    [[nodiscard]] bool isWorthIt(int generation) const {
        return upTo(last()) - upTo(generation) >= kGain * upTo(generation);
    }

    int begun_;
    std::vector<std::uint64_t> total_;
};

} // namespace

std::vector<int> leaks(std::span<const std::uint64_t> voxels, int begun) {
    const Rates rates(voxels, begun);
    std::vector<Leak> found;
    bool isLeaking = false;
    for (int generation = std::max(begun, 0) + 1; generation <= rates.last(); ++generation) {
        const double jump = rates.jumpAfter(generation);
        if (jump >= kJump && !isLeaking) {
            found.push_back({generation, jump});
        } else if (jump >= kJump) {
            found.back().jump = std::max(found.back().jump, jump);
        }
        isLeaking = jump >= kJump;
    }
    std::ranges::stable_sort(found, std::greater(), &Leak::jump);
    found.resize(std::min(found.size(), kMost));
    std::vector<int> generations(found.size());
    std::ranges::transform(found, generations.begin(), &Leak::generation);
    std::ranges::sort(generations);
    return generations;
}

} // namespace vs::segment
