// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/sculpture/fine_sculpture.h"

#include <cstdint>
#include <functional>

namespace vs::sculpt {

// Reads values of a fine sculpture's bricks, of neighbouring places at best one after the other.
class FineReader {
public:
    FineReader(const FineBricks& bricks, glm::ivec3 dims, Precision precision);

    [[nodiscard]] glm::ivec3 counts() const { return counts_; }
    [[nodiscard]] Box3 boxOf(glm::ivec3 brick) const;
    // The brick of a place in voxels; null: nothing is cut there.
    [[nodiscard]] const std::vector<std::byte>* brickAt(glm::ivec3 brick);
    // The value of a voxel; beyond the grid that of the nearest.
    [[nodiscard]] float at(glm::ivec3 voxel);
    // Trilinear between voxels.
    [[nodiscard]] float between(const glm::dvec3& place);
    // Smallest and greatest value in a box that lies within the grid.
    [[nodiscard]] glm::vec2 rangeOf(const Box3& voxels);

private:
    [[nodiscard]] float decoded(const std::vector<std::byte>& texels, std::size_t n) const;

    const FineBricks& bricks_;
    glm::ivec3 dims_;
    glm::ivec3 counts_;
    Precision precision_;
    std::size_t texelBytes_;
    int place_ = -1; // of the brick that was used last
    const std::vector<std::byte>* last_ = nullptr;
};

// Samples of a fine sculpture at the voxels of another grid: voxel v lies at v * scale + offset in the fine
// one.
struct OtherGrid {
    glm::dvec3 scale{1};
    glm::dvec3 offset{0};

    [[nodiscard]] glm::dvec3 finePlace(glm::ivec3 voxel) const { return glm::dvec3(voxel) * scale + offset; }
};
// Calls tell(number, value) for the voxels of a box (numbered x fastest) that bricks with something cut
// reach, some of them more than once; all others are 0.
void sample(FineReader& reader, const FineBricks& bricks, const OtherGrid& grid, const Box3& voxels,
            const std::function<void(std::size_t, float)>& tell);

} // namespace vs::sculpt
