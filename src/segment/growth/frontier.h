// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/buffer.h"
#include "gl/texel_buffer.h"
#include "segment/growth/constraints.h"
#include "segment/growth/seed_map.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vs::segment {

// Expands a set of voxels by whole generations and writes them into the seed map. There are two, which give
// the same to the byte: one computes on the device, the other on the host. What they keep beside the seed map
// can be made anew from it. Internal to this folder.
class Frontier {
public:
    // What a run's expansions go by.
    struct Rules {
        const field::Field* field = nullptr;
        const Constraints* constraints = nullptr;
        const gl::Buffer* forbidden = nullptr; // a plane of voxels that may not be entered; null: none
        Owner owner;
        int frozen = 0; // generations up to this one do not grow any more
    };

    Frontier() = default;
    Frontier(const Frontier&) = delete;
    Frontier& operator=(const Frontier&) = delete;
    virtual ~Frontier() = default;

    // Whether voxels (linear indices) can be seeds now, where generations after the playhead count as not
    // grown.
    enum class SeedAnswer : std::uint32_t { Refused, Present, Admitted, AdmittedAgain };
    virtual std::vector<SeedAnswer> testSeeds(SeedMap& seedMap, const Rules& rules, int playhead,
                                              std::span<const std::uint32_t> voxels) = 0;

    // The rules or the seed map have changed: the next expansion tests voxels that were refused again, and
    // tries the neighbours of every grown voxel.
    virtual void invalidate() = 0;
    // Voxels (linear indices) that were given the newest generation.
    virtual void add(std::span<const std::uint32_t> voxels) = 0;

    // Tries at most `expansions` (at most mostExpansions()) expansions; the first gives `generation`. Returns
    // the voxels grown by each one tried. The device's spans of the seed map's bricks are up to date then,
    // also when this throws.
    virtual std::vector<std::uint64_t> expand(SeedMap& seedMap, const Rules& rules, int generation,
                                              int expansions) = 0;
    [[nodiscard]] virtual int mostExpansions() const = 0;

    // Spreads a set through a region, both planes of bits: from `seeds`, which become part of it, by at most
    // so many expansions. Only the connectivity and the rules for pairs of the constraints count. Returns how
    // many expansions found something. Invalidates.
    virtual int flood(const SeedMap& seedMap, const Rules& rules, std::span<const std::uint32_t> seeds,
                      const gl::TexelBuffer& region, const gl::Buffer& reached, int expansions) = 0;

    // What it takes, on the device or the host.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

// Where growth is computed.
enum class GrowthEngine { Device, Host };
// The one that is quicker here: the host where the device is one too.
GrowthEngine quickerEngine();
std::unique_ptr<Frontier> makeFrontier(GrowthEngine engine, const SeedMap& seedMap,
                                       const field::Field& field);

} // namespace vs::segment
