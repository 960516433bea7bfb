// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/sparse/sparse_bricks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vs::field {

// Material that a person has added to a scan. It lies in the scan's voxel space: of each voxel it is known
// how much of it is filled, and with which material. A place is filled where that is at least a half, between
// voxels by trilinear interpolation; there the material is what is there, whatever the scan has and however
// much of that was cut away.

inline constexpr int kFillBrick = 16; // voxels along a side of a brick
inline constexpr int kFillVoxels = kFillBrick * kFillBrick * kFillBrick;
inline constexpr int kMostMaterials = 31; // numbered from 1
inline constexpr std::uint16_t kWhollyFilled = 65535;
inline constexpr std::uint16_t kHalfFilled = 32768; // the least of what counts as filled

// The voxels of a brick, x fastest.
struct FillBrick {
    std::array<std::uint16_t, kFillVoxels> filled{};  // from 0 to kWhollyFilled
    std::array<std::uint8_t, kFillVoxels> material{}; // of voxels of which nothing is filled: 0

    [[nodiscard]] static std::size_t index(glm::ivec3 voxel) { // within the brick
        return (std::size_t(voxel.z) * kFillBrick + std::size_t(voxel.y)) * kFillBrick + std::size_t(voxel.x);
    }
    [[nodiscard]] bool isEmpty() const;
    bool operator==(const FillBrick&) const = default;
};
// A brick that is wholly of one material: the same each time.
std::shared_ptr<const FillBrick> wholeBrick(std::uint8_t material);

// All that is filled of a document. Once made it stays as it is, and shares bricks with what is made of it.
class Fill {
public:
    using Bricks = SparseBricks<FillBrick>;

    Fill() = default;
    explicit Fill(glm::ivec3 dims, Bricks bricks = {}) : dims_(dims), bricks_(std::move(bricks)) {}

    [[nodiscard]] bool isEmpty() const { return bricks_.isEmpty(); }
    [[nodiscard]] glm::ivec3 dims() const { return dims_; } // of the scan, voxels
    [[nodiscard]] const Bricks& bricks() const { return bricks_; }
    [[nodiscard]] Fill with(std::vector<Bricks::Entry> changed) const {
        return Fill(dims_, bricks_.with(std::move(changed)));
    }

    // Bricks along each axis, and their places: x fastest.
    [[nodiscard]] glm::ivec3 brickDims() const { return (dims_ + (kFillBrick - 1)) / kFillBrick; }
    [[nodiscard]] std::uint32_t placeOf(glm::ivec3 brick) const {
        const glm::ivec3 n = brickDims();
        return (std::uint32_t(brick.z) * std::uint32_t(n.y) + std::uint32_t(brick.y)) * std::uint32_t(n.x) +
               std::uint32_t(brick.x);
    }
    [[nodiscard]] glm::ivec3 brickAt(std::uint32_t place) const {
        const glm::uvec3 n(brickDims());
        return {int(place % n.x), int(place / n.x % n.y), int(place / n.x / n.y)};
    }
    // The voxels of a brick; the part of them that the grid has.
    [[nodiscard]] Box3 boxOf(std::uint32_t place) const {
        const glm::ivec3 lo = brickAt(place) * kFillBrick;
        return intersect({lo, lo + kFillBrick}, {glm::ivec3(0), dims_});
    }
    // The smallest box of bricks that has all that is filled within `box`.
    [[nodiscard]] Box3 filledWithin(const Box3& box) const;

    // How much of a voxel is filled, 0 to 1, and with what; of voxels outside the grid, of the nearest.
    struct Voxel {
        float filled = 0;
        std::uint8_t material = 0;
    };
    [[nodiscard]] Voxel at(glm::ivec3 voxel) const;
    // The material at a place in voxel space, 0 where none is: as pictures show it.
    [[nodiscard]] std::uint8_t materialAt(const glm::dvec3& voxel) const;
    // How many voxels are filled with a material (0: any).
    [[nodiscard]] std::size_t voxels(std::uint8_t material = 0) const;

    bool operator==(const Fill& other) const {
        return (isEmpty() && other.isEmpty()) || (dims_ == other.dims_ && bricks_ == other.bricks_);
    }

private:
    glm::ivec3 dims_{0};
    Bricks bricks_;
};
using SharedFill = std::shared_ptr<const Fill>; // never null

// The voxels of a brick and the first of those behind it, which its cells end at: kFillBrick + 1 along each
// axis, x fastest. Beyond the grid are its last ones again.
struct FillCorners {
    static constexpr int kSide = kFillBrick + 1;

    std::vector<std::uint16_t> filled;
    std::vector<std::uint8_t> material;
    bool isEmpty = true;
    std::uint8_t whole = 0; // the material, where all of it is of one
};
FillCorners cornersOf(const Fill& fill, std::uint32_t place);
// The places whose corners differ between two fills of one grid, in order.
std::vector<std::uint32_t> placesWithOtherCorners(const Fill& before, const Fill& now);

// The voxels in which pictures of two fills of a scan may differ.
Box3 changedBetween(const Fill& before, const Fill& now);
// How many voxels differ.
std::size_t changedVoxels(const Fill& before, const Fill& now);

// Fills by energies from 0 to 1, given for the voxels of a box, x fastest: a voxel is filled as much as its
// energy at least, and is of that material where the energy is a half or more, or more than it was filled.
Fill filledBy(const Fill& fill, const Box3& box, const std::vector<float>& energies, std::uint8_t material);
// Takes away by energies: of a voxel at most 1 - energy stays filled, and less than a half where the energy
// is a half or more.
Fill takenBy(const Fill& fill, const Box3& box, const std::vector<float>& energies);
// A fill without one of its materials.
Fill without(const Fill& fill, std::uint8_t material);

} // namespace vs::field
