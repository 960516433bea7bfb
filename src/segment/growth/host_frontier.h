// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/frontier.h"
#include "segment/growth/host_bricks.h"
#include "segment/growth/host_spread.h"
#include "segment/growth/host_values.h"

#include <vector>

namespace vs::segment {

// Expands on the host, in a seed map that it shares with the device. What it keeps lies in the host's memory:
// four bits for each voxel of the bricks that it has come to. Internal to this folder.
class HostFrontier final : public Frontier {
public:
    HostFrontier(const SeedMap& seedMap, const field::Field& field)
        : values_(field), bricks_(seedMap), spread_(bricks_, seedMap.dims()) {}

    std::vector<SeedAnswer> testSeeds(SeedMap& seedMap, const Rules& rules, int playhead,
                                      std::span<const std::uint32_t> voxels) override;
    void invalidate() override;
    void add(std::span<const std::uint32_t> voxels) override;
    std::vector<std::uint64_t> expand(SeedMap& seedMap, const Rules& rules, int generation,
                                      int expansions) override;
    [[nodiscard]] int mostExpansions() const override { return kMaxExpansions; }
    int flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
              const gl::TexelBuffer& region, const gl::Buffer& reached, int expansions) override;
    [[nodiscard]] std::size_t bytes() const override { return bricks_.bytes(); }

private:
    // The most expansions at once, and the voxels after which no further one is tried: some 30 ms.
    static constexpr int kMaxExpansions = 1 << 14;
    static constexpr std::uint64_t kManyVoxels = 3'000'000;

    void collect(const SeedMap& seedMap, const Rules& rules);
    void writeJoined(SeedMap& seedMap) noexcept;

    HostValues values_;
    BricksToGrowInto bricks_;
    HostSpread spread_;
    std::vector<std::uint32_t> added_;
    bool isValid_ = false;
};

} // namespace vs::segment
