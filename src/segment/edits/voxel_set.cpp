// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/voxel_set.h"

#include <algorithm>
#include <numeric>

namespace vs::segment {

std::size_t VoxelSet::indexOf(glm::ivec3 voxel) const {
    const auto p = voxel - box.lo;
    const auto size = box.size();
    return std::size_t(p.x) +
           std::size_t(size.x) * (std::size_t(p.y) + std::size_t(size.y) * std::size_t(p.z));
}

glm::ivec3 VoxelSet::voxelAt(std::size_t index) const {
    const auto x = std::size_t(box.size().x);
    const auto y = std::size_t(box.size().y);
    return box.lo + glm::ivec3(int(index % x), int(index / x % y), int(index / (x * y)));
}

bool VoxelSet::contains(glm::ivec3 voxel) const {
    return glm::all(glm::greaterThanEqual(voxel, box.lo)) && glm::all(glm::lessThan(voxel, box.hi)) &&
           inside[indexOf(voxel)] != 0;
}

std::size_t VoxelSet::count() const { return std::accumulate(inside.begin(), inside.end(), std::size_t{0}); }

Box3 VoxelSet::tightBox() const {
    if (box.isEmpty()) {
        return {};
    }
    Box3 tight{box.hi, box.lo};
    auto row = inside.begin();
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y, row += box.size().x) {
            const auto end = row + box.size().x;
            const auto first = std::find(row, end, 1);
            if (first == end) {
                continue;
            }
            const auto last = std::find(std::reverse_iterator(end), std::reverse_iterator(row), 1).base();
            tight.lo = glm::min(tight.lo, glm::ivec3(box.lo.x + int(first - row), y, z));
            tight.hi = glm::max(tight.hi, glm::ivec3(box.lo.x + int(last - row), y + 1, z + 1));
        }
    }
    return tight.isEmpty() ? Box3{} : tight;
}

VoxelSet VoxelSet::within(const Box3& other) const {
    VoxelSet result = emptySet(other);
    const Box3 shared = intersect(box, other);
    for (int z = shared.lo.z; z < shared.hi.z; ++z) {
        for (int y = shared.lo.y; y < shared.hi.y && shared.lo.x < shared.hi.x; ++y) {
            const glm::ivec3 first(shared.lo.x, y, z);
            std::copy_n(inside.data() + indexOf(first), shared.size().x,
                        result.inside.data() + result.indexOf(first));
        }
    }
    return result;
}

VoxelSet VoxelSet::cropped(int padding, glm::ivec3 gridDims) const {
    const Box3 tight = tightBox();
    return tight.isEmpty() ? VoxelSet{} : within(intersect(grow(tight, padding), {glm::ivec3(0), gridDims}));
}

VoxelSet emptySet(const Box3& box) { return {box, std::vector<std::uint8_t>(box.volume(), 0)}; }

bool operator==(const VoxelSet& a, const VoxelSet& b) {
    const Box3 tight = a.tightBox();
    return tight == b.tightBox() && a.within(tight).inside == b.within(tight).inside;
}

} // namespace vs::segment
