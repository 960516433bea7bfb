// SPDX-License-Identifier: Apache-2.0
// What the membership of a brick is made of. Internal to this folder.
#pragma once

#include "segment/membership/membership.h"
#include "segment/membership/segmentation.h"

#include <cstdint>
#include <vector>

namespace vs::segment {

// Whose a voxel is: 0 nobody's, else a Look.
using Member = std::uint8_t;
constexpr auto kOpaque = Member(Look::Opaque);
constexpr auto kTranslucent = Member(Look::Translucent);
constexpr Member kHidden = 255; // behind a cut: not known yet

// A value for each voxel of a box, x fastest.
template <typename T>
struct Values {
    explicit Values(const Box3& in) : box(in), all(in.volume()) {}
    [[nodiscard]] std::size_t indexOf(glm::ivec3 v) const {
        const glm::ivec3 at = v - box.lo;
        const glm::ivec3 size = box.size();
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
               std::size_t(at.x);
    }
    T& at(glm::ivec3 v) { return all[indexOf(v)]; }
    [[nodiscard]] const T& at(glm::ivec3 v) const { return all[indexOf(v)]; }

    Box3 box;
    std::vector<T> all;
};

using Members = Values<Member>;

// How far segments go on behind a cut: as far as counts for the first voxel behind it.
constexpr int kBehindCuts = kKernelReach + 1;

// What was not known behind a cut becomes what most of its six neighbours are, from the cut on.
void goOnBehindCuts(Members& members);

// Adds up values of up to kKernelReach neighbours to both sides along an axis, weighted; the result is so
// much narrower along it.
Values<float> smoothedAlong(int axis, const glm::vec4& weights, const Values<float>& from);

} // namespace vs::segment
