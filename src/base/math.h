// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace vs {

// Closed interval of values in the volume's own unit (HU, grey level ...).
struct Range {
    double lo = 0;
    double hi = 0;

    [[nodiscard]] bool contains(double value) const { return value >= lo && value <= hi; }
    [[nodiscard]] double width() const { return hi - lo; }
    bool operator==(const Range&) const = default;
};

// Half-open rectangle of pixels [lo, hi), y down; empty when hi <= lo along any axis.
struct Box2 {
    glm::ivec2 lo{0};
    glm::ivec2 hi{0};

    [[nodiscard]] bool isEmpty() const { return hi.x <= lo.x || hi.y <= lo.y; }
    [[nodiscard]] glm::ivec2 size() const { return glm::max(hi - lo, glm::ivec2(0)); }
    bool operator==(const Box2&) const = default;
};

// Half-open box of voxels [lo, hi) in index space; empty when hi <= lo along any axis.
struct Box3 {
    glm::ivec3 lo{0};
    glm::ivec3 hi{0};

    [[nodiscard]] bool isEmpty() const { return hi.x <= lo.x || hi.y <= lo.y || hi.z <= lo.z; }
    [[nodiscard]] glm::ivec3 size() const { return glm::max(hi - lo, glm::ivec3(0)); }
    [[nodiscard]] std::size_t volume() const {
        const auto s = size();
        return std::size_t(s.x) * std::size_t(s.y) * std::size_t(s.z);
    }
    bool operator==(const Box3&) const = default;
};

inline Box3 intersect(const Box3& a, const Box3& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }
inline Box3 grow(const Box3& a, int voxels) { return {a.lo - voxels, a.hi + voxels}; }
inline Box3 unite(const Box3& a, const Box3& b) {
    if (a.isEmpty()) {
        return b;
    }
    return b.isEmpty() ? a : Box3{glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

// Calls `visit` with each voxel of a box and its number, x fastest.
template <typename Visit>
void forEachVoxel(const Box3& box, const Visit& visit) {
    glm::ivec3 v;
    std::size_t i = 0;
    for (v.z = box.lo.z; v.z < box.hi.z; ++v.z) {
        for (v.y = box.lo.y; v.y < box.hi.y; ++v.y) {
            for (v.x = box.lo.x; v.x < box.hi.x; ++v.x) {
                visit(v, i++);
            }
        }
    }
}

// Number of blocks of the given size that cover n elements.
inline int divideUp(int n, int block) { return (n + block - 1) / block; }
inline glm::ivec3 divideUp(glm::ivec3 n, int block) { return (n + block - 1) / block; }

} // namespace vs
