// SPDX-License-Identifier: Apache-2.0
// What the membership of a brick is made of. Internal to this folder.
#pragma once

#include "segment/membership/membership.h"
#include "segment/membership/segmentation.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace vs::segment {

// Whose a voxel is: 0 nobody's, else a Look.
using Member = std::uint8_t;
constexpr auto kOpaque = Member(Look::Opaque);
constexpr auto kTranslucent = Member(Look::Translucent);
constexpr Member kBehind = 128; // added to these: behind a cut, where nobody's is not known

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

// Whose voxels are, and the labels of those who have them: 0 for nobody.
struct Owned {
    explicit Owned(const Box3& box) : members(box), labels(box) {}

    Members members;
    Values<std::uint8_t> labels;
};

// Whose voxels of a coarse level are, found from the finer ones in them.
class Shares {
public:
    explicit Shares(const Box3& box) : of_(box) {}
    // One of the finer voxels in v.
    void add(glm::ivec3 v, Member whose, std::uint8_t label);
    // Who has at least half of the `finerIn` voxels in one, or any where nobody around has half. Its label is
    // that of the segment which has more than half of those voxels, or of one that has some.
    [[nodiscard]] Owned owned(const std::function<std::size_t(glm::ivec3)>& finerIn) const;

private:
    struct Share {
        std::array<std::uint32_t, 3> counts{}; // by Member
        std::array<std::uint32_t, 3> leads{}; // how far the label below is ahead, by Member (Boyer and Moore)
        std::array<std::uint8_t, 3> labels{};

        [[nodiscard]] Member most() const {
            return counts[kOpaque] >= counts[kTranslucent] ? kOpaque : kTranslucent;
        }
    };
    void addThin(const std::vector<glm::ivec3>& some, Owned& owned) const;

    Values<Share> of_;
};

// How far segments go on behind a cut: as far as counts for the first voxel behind it.
constexpr int kBehindCuts = kKernelReach + 1;

// What is not known behind a cut becomes what most of its six neighbours are, from those in front of the cut
// on. Nothing is marked as behind any more.
void goOnBehindCuts(Members& members);

// Adds up values of up to kKernelReach neighbours to both sides along an axis, weighted; the result is so
// much narrower along it.
Values<float> smoothedAlong(int axis, const glm::vec4& weights, const Values<float>& from);

// How much of the voxels in a box belongs to one of them, from 0 to 255: at least half at its voxels, less at
// all others. `members` are known as far around the box as the kernel reaches; `spacing` in mm.
Values<std::uint8_t> membershipOf(const Members& members, Member whose, const Box3& own,
                                  const glm::dvec3& spacing, Smoothing smoothing);

} // namespace vs::segment
