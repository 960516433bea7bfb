// SPDX-License-Identifier: Apache-2.0
#include "segment/membership/fine_members.h"

#include <algorithm>
#include <array>
#include <utility>

namespace vs::segment {

void goOnBehindCuts(Members& members) {
    std::vector<glm::ivec3> hidden;
    forEachVoxel(members.box, [&](glm::ivec3 v, std::size_t i) {
        if (members.all[i] == kHidden) {
            hidden.push_back(v);
        }
    });
    for (int step = 0; step < kBehindCuts && !hidden.empty(); ++step) {
        std::vector<std::pair<glm::ivec3, Member>> found;
        std::vector<glm::ivec3> left;
        for (const glm::ivec3 v : hidden) {
            std::array<int, 3> counts{};
            for (int axis = 0; axis < 3; ++axis) {
                for (const int side : {-1, 1}) {
                    glm::ivec3 near = v;
                    near[axis] += side;
                    const bool isInside =
                        near[axis] >= members.box.lo[axis] && near[axis] < members.box.hi[axis];
                    const Member whose = isInside ? members.at(near) : kHidden;
                    if (whose != kHidden) {
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
        hidden.swap(left);
    }
    for (const glm::ivec3 v : hidden) {
        members.at(v) = 0;
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

} // namespace vs::segment
