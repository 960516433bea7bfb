// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "property.h"
#include "segment/edits/voxel_set.h"
#include "volume/grid/geometry.h"

#include <functional>
#include <random>

namespace vs::segment {

// Calls f with each voxel of the box, x fastest.
inline void forEachPlace(const Box3& box, const std::function<void(glm::ivec3)>& f) {
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            for (int x = box.lo.x; x < box.hi.x; ++x) {
                f({x, y, z});
            }
        }
    }
}

// The voxels of the box for which `isInside` holds.
inline VoxelSet setWhere(const Box3& box, const std::function<bool(glm::ivec3)>& isInside) {
    VoxelSet set = emptySet(box);
    std::size_t next = 0;
    forEachPlace(box, [&](glm::ivec3 voxel) { set.inside[next++] = isInside(voxel) ? 1 : 0; });
    return set;
}

// Each voxel with the same probability, independently.
inline VoxelSet randomSet(const Box3& box, double probability, unsigned seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution toss(probability);
    return setWhere(box, [&](glm::ivec3) { return toss(random); });
}

// Up to `most` voxels of the box anywhere, some of them perhaps the same one; shrinks voxel by voxel.
inline rc::Gen<VoxelSet> anySet(const Box3& box, int most) {
    return rc::gen::map(test::upTo(most, test::below(int(emptySet(box).inside.size()))),
                        [box](const std::vector<int>& places) {
                            VoxelSet set = emptySet(box);
                            for (const int place : places) {
                                set.inside[std::size_t(place)] = 1;
                            }
                            return set;
                        });
}

// For counterexamples.
inline void showValue(const VoxelSet& set, std::ostream& out) {
    out << "voxels";
    for (std::size_t i = 0; i < set.inside.size(); ++i) {
        const glm::ivec3 v = set.voxelAt(i);
        if (set.inside[i] != 0) {
            out << " (" << v.x << ' ' << v.y << ' ' << v.z << ')';
        }
    }
    out << " of the box from (" << set.box.lo.x << ' ' << set.box.lo.y << ' ' << set.box.lo.z << ") to ("
        << set.box.hi.x << ' ' << set.box.hi.y << ' ' << set.box.hi.z << ')';
}

inline VoxelSet boxSet(const Box3& box) {
    return setWhere(box, [](glm::ivec3) { return true; });
}

inline VoxelSet complementIn(const Box3& box, const VoxelSet& set) {
    return setWhere(box, [&](glm::ivec3 voxel) { return !set.contains(voxel); });
}

inline double distanceMm(const volume::GridGeometry& geometry, glm::dvec3 a, glm::dvec3 b) {
    return glm::length(glm::dmat3(geometry.worldFromVoxel) * (a - b));
}

// Voxels whose centres are at most `mm` from that of `centre`.
inline VoxelSet ball(const volume::GridGeometry& geometry, glm::dvec3 centre, double mm) {
    return setWhere(geometry.box(),
                    [&](glm::ivec3 voxel) { return distanceMm(geometry, voxel, centre) <= mm * (1 + 1e-9); });
}

inline bool isSubset(const VoxelSet& a, const VoxelSet& b) {
    bool result = true;
    forEachPlace(a.box,
                 [&](glm::ivec3 voxel) { result = result && (!a.contains(voxel) || b.contains(voxel)); });
    return result;
}

} // namespace vs::segment
