// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/field.h"
#include "gl/buffer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vs::segment {

// The bricks of 32^3 voxels that a box touches, as ranges of brick coordinates.
inline Box3 bricksAround(const Box3& box) {
    return {box.lo / field::kBrick, divideUp(box.hi, field::kBrick)};
}
// Where a voxel of a box stands in a list of them, x fastest.
inline std::size_t indexIn(const Box3& box, glm::ivec3 voxel) {
    const glm::ivec3 size = box.size();
    const glm::ivec3 at = voxel - box.lo;
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
           std::size_t(at.x);
}

// The first and the last generation found in a brick of 32^3 voxels; 0, 0 when nothing has grown there. After
// voxels were erased the span may be wider than what is left.
struct GenerationSpan {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    bool operator==(const GenerationSpan&) const = default;
};

// Which bricks growth has reached and when, on the device (written while growing) and on the CPU, and when
// what a brick shows last changed. Bricks are numbered x fastest.
class BrickTable {
public:
    explicit BrickTable(glm::ivec3 dims);

    [[nodiscard]] glm::ivec3 brickDims() const { return brickDims_; }
    [[nodiscard]] std::size_t count() const { return spans_.size(); }
    [[nodiscard]] const gl::Buffer& onDevice() const { return onDevice_; }
    // Voxels of one brick, clipped to the grid.
    [[nodiscard]] Box3 box(std::uint32_t brick) const;
    [[nodiscard]] glm::ivec3 brickAt(std::uint32_t brick) const;
    [[nodiscard]] std::uint32_t brickOf(glm::ivec3 voxel) const;
    [[nodiscard]] GenerationSpan span(std::uint32_t brick) const { return spans_[brick]; }
    // Whether the brick may hold voxels of any segment.
    [[nodiscard]] bool isOccupied(std::uint32_t brick) const {
        return isOccupied_[brick] || spans_[brick].first != 0;
    }
    void setSpan(std::uint32_t brick, GenerationSpan span) { spans_[brick] = span; }
    // Bricks that may hold a generation in (after, upTo]; all that hold anything.
    [[nodiscard]] std::vector<std::uint32_t> holding(int after, int upTo) const;
    [[nodiscard]] std::vector<std::uint32_t> touched() const;
    // Bricks that may hold voxels of any segment.
    [[nodiscard]] std::vector<std::uint32_t> occupied() const;

    // Reads what the device has written.
    void download();
    // Writes for the device what was changed here.
    void upload();
    // Widens a brick's span by a voxel of this generation, which must not be older than any in it.
    void add(glm::ivec3 voxel, int generation);
    // Widens the spans of whole bricks by a generation, which must not be older than any in them.
    void widen(std::span<const std::uint32_t> bricks, int generation);
    // Takes another segment's spans (empty: it has none yet) for those there are, which it returns. Needs
    // memory only where they are empty.
    std::vector<GenerationSpan> exchangeSpans(std::vector<GenerationSpan> spans);
    // Takes note that these bricks may hold voxels of segments that are not at work.
    void occupy(const std::vector<std::uint32_t>& bricks);
    // Takes note that generations after `last` were erased.
    void truncate(int last);

    // Counts changes of what is shown; bricks changed since an earlier count.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    [[nodiscard]] std::vector<std::uint32_t> changedSince(std::uint64_t revision) const;
    void markChanged(const std::vector<std::uint32_t>& bricks);

private:
    glm::ivec3 dims_;
    glm::ivec3 brickDims_;
    gl::Buffer onDevice_;
    std::vector<GenerationSpan> spans_;
    std::vector<bool> isOccupied_; // by a segment that is not at work
    std::vector<std::uint64_t> changedAt_;
    std::uint64_t revision_ = 0;
};

} // namespace vs::segment
