// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/sparse/sparse_bricks.h"
#include "volume/grid/geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vs::field {

// Colours that a person has laid on the material of a scan. They lie in space, in texels that are finer than
// the scan's voxels, and in bricks of these that exist only where something is marked.

inline constexpr int kMarkBrick = 16; // texels along a side of a brick
inline constexpr int kMarkTexels = kMarkBrick * kMarkBrick * kMarkBrick;
// Coverage goes from none to all over so many texels about a mark's edge, where it is a half.
inline constexpr double kMarkRamp = 3;

// The texels of marks: so many along each axis of each voxel, about half a step of the scan wide or, where
// that would be more than 1280 along the longest axis, a whole one.
struct MarkGrid {
    glm::ivec3 dims{0};     // of the scan, voxels
    glm::ivec3 perVoxel{1}; // texels

    [[nodiscard]] glm::ivec3 texels() const { return dims * perVoxel; }
    [[nodiscard]] glm::ivec3 bricks() const { return (texels() + (kMarkBrick - 1)) / kMarkBrick; }
    // Places of one space in the other; centres of texels, as of voxels, are at whole numbers.
    [[nodiscard]] glm::dvec3 texelFromVoxel(const glm::dvec3& p) const {
        return (p + 0.5) * glm::dvec3(perVoxel) - 0.5;
    }
    [[nodiscard]] glm::dvec3 voxelFromTexel(const glm::dvec3& q) const {
        return (q + 0.5) / glm::dvec3(perVoxel) - 0.5;
    }
    [[nodiscard]] std::uint32_t placeOf(glm::ivec3 brick) const {
        const glm::ivec3 n = bricks();
        return (std::uint32_t(brick.z) * std::uint32_t(n.y) + std::uint32_t(brick.y)) * std::uint32_t(n.x) +
               std::uint32_t(brick.x);
    }
    [[nodiscard]] glm::ivec3 brickAt(std::uint32_t place) const {
        const glm::uvec3 n(bricks());
        return {int(place % n.x), int(place / n.x % n.y), int(place / n.x / n.y)};
    }
    // How wide a texel is on the widest axis, where the voxels lie now.
    [[nodiscard]] double texelMm(const volume::GridGeometry& geometry) const {
        const glm::dvec3 mm = geometry.spacing() / glm::dvec3(perVoxel);
        return std::max({mm.x, mm.y, mm.z});
    }
    bool operator==(const MarkGrid&) const = default;
};
inline constexpr int kMostMarksPerVoxel = 32;                          // texels along an axis
inline constexpr std::int64_t kMostMarkBricks = std::int64_t(1) << 26; // of a grid
MarkGrid markGridOf(const volume::GridGeometry& geometry);

// What a texel of marks holds. Colour and opacity are those of the mark that is there, also a little beyond
// its edge; coverage says on which side of that the texel lies, 128 about on it.
struct MarkTexel {
    std::uint8_t red = 0; // sRGB
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t opacity = 0;
    std::uint8_t coverage = 0;

    bool operator==(const MarkTexel&) const = default;
};

// The texels of a brick, x fastest.
struct MarkBrick {
    std::array<std::array<std::uint8_t, 4>, kMarkTexels> colours{}; // red, green, blue, opacity
    std::array<std::uint8_t, kMarkTexels> coverage{};

    [[nodiscard]] static std::size_t index(glm::ivec3 texel) { // within the brick
        return (std::size_t(texel.z) * kMarkBrick + std::size_t(texel.y)) * kMarkBrick + std::size_t(texel.x);
    }
    [[nodiscard]] MarkTexel at(std::size_t i) const {
        return {colours[i][0], colours[i][1], colours[i][2], colours[i][3], coverage[i]};
    }
    void set(std::size_t i, const MarkTexel& texel) {
        colours[i] = {texel.red, texel.green, texel.blue, texel.opacity};
        coverage[i] = texel.coverage;
    }
    [[nodiscard]] bool isEmpty() const;
    bool operator==(const MarkBrick&) const = default;
};

// All marks of a document. Once made they stay as they are: edits make others, which share the bricks that
// they leave alone, so that undo holds what has changed and no more.
class Marks {
public:
    using Brick = SparseBricks<MarkBrick>::Brick;
    using Entry = SparseBricks<MarkBrick>::Entry; // MarkGrid::placeOf()

    Marks() = default;
    // Bricks in the order of their places, none of them null or without coverage.
    Marks(const MarkGrid& grid, std::vector<Entry> bricks) : grid_(grid), bricks_(std::move(bricks)) {}

    [[nodiscard]] bool isEmpty() const { return bricks_.isEmpty(); }
    [[nodiscard]] const MarkGrid& grid() const { return grid_; }
    [[nodiscard]] const std::vector<Entry>& bricks() const { return bricks_.entries(); }
    // Null: nothing is marked there.
    [[nodiscard]] const MarkBrick* find(std::uint32_t place) const { return bricks_.at(place).get(); }
    // These with other bricks in the places named (in order; null or empty ones are taken away).
    [[nodiscard]] Marks with(std::vector<Entry> changed) const {
        Marks other;
        other.grid_ = grid_;
        other.bricks_ = bricks_.with(std::move(changed));
        return other;
    }
    [[nodiscard]] MarkTexel texelAt(glm::ivec3 texel) const; // anywhere
    // The colour (sRGB, 0 to 1) and opacity at a place in voxel space, interpolated as pictures do.
    [[nodiscard]] glm::dvec4 colourAt(const glm::dvec3& voxel) const;
    [[nodiscard]] std::size_t memoryBytes() const { return bricks().size() * sizeof(MarkBrick); }
    bool operator==(const Marks& other) const;

private:
    friend std::vector<std::uint32_t> changedBricks(const Marks& before, const Marks& now);

    MarkGrid grid_;
    SparseBricks<MarkBrick> bricks_;
};
using SharedMarks = std::shared_ptr<const Marks>; // never null

// The colour (sRGB) and opacity of each voxel of the scan, x fastest: the mean of its texels, 0 where nothing
// is marked.
std::vector<std::array<std::uint8_t, 4>> coloursOfVoxels(const Marks& marks);

// The voxels in which pictures of two sets of marks may differ. Both are of one grid, or one is empty.
Box3 changedBetween(const Marks& before, const Marks& now);
// The places of bricks that differ, in order.
std::vector<std::uint32_t> changedBricks(const Marks& before, const Marks& now);

} // namespace vs::field
