// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/fine_members.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vs::segment {

void Shares::add(glm::ivec3 v, Member whose, std::uint8_t label) {
    Share& share = of_.at(v);
    ++share.counts[whose];
    std::uint32_t& lead = share.leads[whose];
    share.labels[whose] = lead == 0 ? label : share.labels[whose];
    lead = share.labels[whose] == label ? lead + 1 : lead - 1;
}

Owned Shares::owned(const std::function<std::size_t(glm::ivec3)>& finerIn) const {
    Owned owned(of_.box);
    std::vector<glm::ivec3> some; // which have less than half
    forEachVoxel(of_.box, [&](glm::ivec3 v, std::size_t i) {
        const Share& share = of_.all[i];
        const Member most = share.most();
        if (share.counts[most] == 0) {
            return;
        }
        const std::size_t half = std::max<std::size_t>((finerIn(v) + 1) / 2, 1);
        if (share.counts[most] < half) {
            some.push_back(v);
            return;
        }
        owned.members.all[i] = most;
        owned.labels.all[i] = share.labels[most];
    });
    addThin(some, owned);
    return owned;
}

void Shares::addThin(const std::vector<glm::ivec3>& some, Owned& owned) const {
    std::vector<glm::ivec3> thin;
    for (const glm::ivec3 v : some) {
        const Member most = of_.at(v).most();
        bool isThin = true;
        forEachVoxel(intersect(grow(Box3{v, v + 1}, 1), of_.box), [&](glm::ivec3 near, std::size_t) {
            isThin = isThin && owned.members.at(near) != most;
        });
        if (isThin) {
            thin.push_back(v);
        }
    }
    for (const glm::ivec3 v : thin) {
        const Share& share = of_.at(v);
        owned.members.at(v) = share.most();
        owned.labels.at(v) = share.labels[share.most()];
    }
}

void goOnBehindCuts(Members& members) {
    std::vector<glm::ivec3> unknown;
    forEachVoxel(members.box, [&](glm::ivec3 v, std::size_t i) {
        if (members.all[i] == kBehind) {
            unknown.push_back(v);
        }
    });
    for (int step = 0; step < kBehindCuts && !unknown.empty(); ++step) {
        std::vector<std::pair<glm::ivec3, Member>> found;
        std::vector<glm::ivec3> left;
        for (const glm::ivec3 v : unknown) {
            std::array<int, 3> counts{};
            for (int axis = 0; axis < 3; ++axis) {
                for (const int side : {-1, 1}) {
                    glm::ivec3 near = v;
                    near[axis] += side;
                    const bool isInside =
                        near[axis] >= members.box.lo[axis] && near[axis] < members.box.hi[axis];
                    const Member whose = isInside ? members.at(near) : kBehind;
                    if (whose < kBehind) {
                        ++counts[whose];
                    }
                }
            }
            const auto most = std::max_element(counts.begin(), counts.end());
            if (*most > 0) {
                found.emplace_back(v, Member(most - counts.begin()));
            } else {
                left.push_back(v);
            }
        }
        for (const auto& [v, whose] : found) {
            members.at(v) = whose;
        }
        unknown.swap(left);
    }
    for (Member& whose : members.all) {
        whose = whose >= kBehind ? Member(whose - kBehind) : whose;
    }
}

Values<float> smoothedAlong(int axis, const glm::vec4& weights, const Values<float>& from) {
    Box3 box = from.box;
    box.lo[axis] += kKernelReach;
    box.hi[axis] -= kKernelReach;
    Values<float> to(box);
    const glm::ivec3 size = from.box.size();
    const std::size_t stride = axis == 0   ? 1
                               : axis == 1 ? std::size_t(size.x)
                                           : std::size_t(size.x) * std::size_t(size.y);
    const auto width = std::size_t(box.size().x);
    for (int z = box.lo.z; z < box.hi.z; ++z) {
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            const float* in = &from.at({box.lo.x, y, z});
            float* out = &to.at({box.lo.x, y, z});
            for (std::size_t x = 0; x < width; ++x) {
                const float* middle = in + x;
                out[x] = weights.x * middle[0] + weights.y * (*(middle - stride) + middle[stride]) +
                         weights.z * (*(middle - 2 * stride) + middle[2 * stride]) +
                         weights.w * (*(middle - 3 * stride) + middle[3 * stride]);
            }
        }
    }
    return to;
}

Values<std::uint8_t> membershipOf(const Members& members, Member whose, const Box3& own,
                                  const glm::dvec3& spacing, Smoothing smoothing) {
    Values<float> values(grow(own, kKernelReach)); // nothing lies outside the grid
    forEachVoxel(intersect(values.box, members.box),
                 [&](glm::ivec3 v, std::size_t) { values.at(v) = members.at(v) == whose ? 1.0F : 0.0F; });
    const double step = std::min({spacing.x, spacing.y, spacing.z});
    for (int axis = 0; smoothing == Smoothing::Smooth && axis < 3; ++axis) {
        values = smoothedAlong(axis, smoothingKernel(step, spacing[axis]), values);
    }
    Values<std::uint8_t> result(own);
    forEachVoxel(own, [&](glm::ivec3 v, std::size_t i) {
        const bool isMember = members.at(v) == whose;
        const int texel = int(std::lround(std::clamp(values.at(v), 0.0F, 1.0F) * 255));
        result.all[i] = std::uint8_t(isMember ? std::max(texel, 255 - texel) : std::min(texel, 255 - texel));
    });
    return result;
}

} // namespace vs::segment
