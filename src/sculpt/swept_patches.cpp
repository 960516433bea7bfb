// SPDX-License-Identifier: Apache-2.0
#include "sculpt/swept_patches.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr int kMaxAcross = 64;  // samples along u or v
constexpr int kMaxAlong = 4096; // samples along depth

// How far apart two neighbouring paths are for sampling, squared. The part along their direction counts a
// third: columns overlap along it, so it matters only where they end.
float gapSquared(const glm::vec3& between, const glm::vec3& direction, float directionSquared) {
    const float along = glm::dot(between, direction);
    return glm::dot(between, between) - (8.0F / 9.0F) * along * along / directionSquared;
}

int samplesFor(float lengthSquared, int most) {
    const float wanted = std::ceil(std::sqrt(std::max(lengthSquared, 0.0F)) / SweptPatches::kSpacing);
    return int(std::clamp(wanted, 1.0F, float(most)));
}

} // namespace

std::uint32_t SweptPatches::addCorner(const glm::vec3& start, const glm::vec3& direction, float mask) {
    corners_.push_back({glm::vec4(start, mask), glm::vec4(direction, 0)});
    return std::uint32_t(corners_.size() - 1);
}

void SweptPatches::reserve(std::size_t corners, std::size_t patches) {
    corners_.reserve(corners);
    patches_.reserve(patches);
}

void SweptPatches::addCell(const std::array<std::uint32_t, 4>& corners) {
    std::array<float, 4> mask{};
    std::transform(corners.begin(), corners.end(), mask.begin(),
                   [&](std::uint32_t n) { return corners_[n].start.w; });
    const float sum = mask[0] + mask[1] + mask[2] + mask[3];
    if (sum > 0) {
        addPatch(corners, sum / 4, {(mask[1] + mask[3]) / sum, (mask[2] + mask[3]) / sum}, true);
    }
}

void SweptPatches::addBlock(const std::array<std::uint32_t, 4>& corners, float mask, glm::vec2 centroid) {
    addPatch(corners, mask, centroid, false);
}

void SweptPatches::addPatch(const std::array<std::uint32_t, 4>& corners, float mean, glm::vec2 centroid,
                            bool isBilinear) {
    std::array<glm::vec3, 4> begin;
    std::array<glm::vec3, 4> end;
    glm::vec3 direction(0);
    float longest = 0;
    for (std::size_t n = 0; n < 4; ++n) {
        const SweptCorner& corner = corners_[corners[n]];
        const glm::vec3 along(corner.direction);
        begin[n] = glm::vec3(corner.start) + depthLo_ * along;
        end[n] = glm::vec3(corner.start) + depthHi_ * along;
        lo_ = glm::min(lo_, glm::min(begin[n], end[n]));
        hi_ = glm::max(hi_, glm::max(begin[n], end[n]));
        direction += along;
        longest = std::max(longest, glm::dot(along, along));
    }
    const float squared = std::max(glm::dot(direction, direction), 1e-12F);
    const auto gap = [&](std::size_t a, std::size_t b) {
        return std::max(gapSquared(begin[b] - begin[a], direction, squared),
                        gapSquared(end[b] - end[a], direction, squared));
    };
    const int nu = samplesFor(std::max(gap(0, 1), gap(2, 3)), kMaxAcross);
    const int nv = samplesFor(std::max(gap(0, 2), gap(1, 3)), kMaxAcross);
    const float depth = depthHi_ - depthLo_;
    const int nd = samplesFor(longest * depth * depth, std::min(kMaxAlong, kMaxPatchPoints / (nu * nv)));
    const float mask = isBilinear && nu * nv > 1 ? -1 : mean;
    const glm::vec2 offset(nu == 1 ? centroid.x - 0.5F : 0.0F, nv == 1 ? centroid.y - 0.5F : 0.0F);
    patches_.push_back({corners, std::uint32_t(pointCount_),
                        std::uint32_t(nu) | std::uint32_t(nv) << 8U | std::uint32_t(nd) << 16U, mask,
                        glm::packSnorm2x16(offset)});
    pointCount_ += std::size_t(nu) * std::size_t(nv) * std::size_t(nd);
}

Box3 SweptPatches::pointBox() const {
    if (patches_.empty()) {
        return {};
    }
    // Far outside every grid is as good as infinitely far, and safe to convert.
    const glm::vec3 lo = glm::clamp(lo_, glm::vec3(-1e6F), glm::vec3(1e6F));
    const glm::vec3 hi = glm::clamp(hi_, glm::vec3(-1e6F), glm::vec3(1e6F));
    return {glm::ivec3(glm::floor(lo + 0.5F)), glm::ivec3(glm::floor(hi + 0.5F)) + 1};
}

} // namespace vs::sculpt
