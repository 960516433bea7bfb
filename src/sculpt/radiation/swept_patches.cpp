// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/swept_patches.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr int kMaxAcross = 64;  // samples along u or v
constexpr int kMaxAlong = 4096; // samples along depth
constexpr int kMaxLevel = 40;   // splits of one patch

// How far apart two neighbouring paths are for sampling, squared. The part along their direction counts a
// third: columns overlap along it, so it matters only where they end.
float gapSquared(const glm::vec3& between, const glm::vec3& direction, float directionSquared) {
    const float along = glm::dot(between, direction);
    return glm::dot(between, between) - (8.0F / 9.0F) * along * along / directionSquared;
}

float samplesFor(float lengthSquared) {
    return std::max(std::ceil(std::sqrt(std::max(lengthSquared, 0.0F)) / SweptPatches::kSpacing), 1.0F);
}

int clampCount(float wanted, int most) { return int(std::clamp(wanted, 1.0F, float(most))); }

// How far a path goes either way from where it begins before it meets its neighbours.
struct Reach {
    float back = -1e30F;
    float forth = 1e30F;
};

// a + b t + c t^2, positive at 0, ends at its roots on either side.
void endAtRoots(Reach& reach, float a, float b, float c) {
    const float discriminant = b * b - 4 * a * c;
    if (discriminant >= 0) {
        const float root = std::sqrt(discriminant);
        if (root - b > 0) {
            reach.forth = std::min(reach.forth, 2 * a / (root - b));
        }
        if (-root - b < 0) {
            reach.back = std::max(reach.back, 2 * a / (-root - b));
        }
    }
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
    add({corners, {depthLo_, depthHi_}, 0, glm::vec2(0.5F), true, 0});
}

void SweptPatches::addBlock(const std::array<std::uint32_t, 4>& corners, float mask, glm::vec2 centroid) {
    add({corners, {depthLo_, depthHi_}, mask, centroid, false, 0});
}

void SweptPatches::add(const Part& part) {
    if (inPieces_) {
        noted_.push_back(part);
        ownCorners_ = corners_.size();
    } else {
        addPart(part);
    }
}

void SweptPatches::sweepPiece(float depthLo, float depthHi) {
    corners_.resize(ownCorners_);
    patches_.clear();
    pointCount_ = 0;
    lo_ = glm::vec3(1e30F);
    hi_ = glm::vec3(-1e30F);
    for (Part part : noted_) {
        part.depths = {depthLo, depthHi};
        addPart(part);
    }
}

SweptPatches::Quad SweptPatches::quad(const std::array<std::uint32_t, 4>& corners) const {
    return {corners_[corners[0]], corners_[corners[1]], corners_[corners[2]], corners_[corners[3]]};
}

// At any depth a patch lies within the hull of its four corners: it is beyond a plane when all four are.
std::optional<SweptPatches::Interval> SweptPatches::clipped(const Quad& quad, Interval depths) const {
    const bool isInside = std::all_of(quad.begin(), quad.end(), [&](const SweptCorner& corner) {
        const glm::vec3 begin(corner.start + depths.lo * corner.direction);
        const glm::vec3 end(corner.start + depths.hi * corner.direction);
        return glm::all(glm::lessThanEqual(clipLo_, glm::min(begin, end))) &&
               glm::all(glm::lessThanEqual(glm::max(begin, end), clipHi_));
    });
    if (isInside) {
        return depths;
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {1.0F, -1.0F}) {
            const float limit = side > 0 ? clipHi_[axis] : -clipLo_[axis];
            Interval inside{depths.hi, depths.lo}; // empty
            for (const SweptCorner& corner : quad) {
                const float start = side * corner.start[axis];
                const float speed = side * corner.direction[axis];
                Interval own = depths; // where start + depth * speed <= limit
                if (speed > 0) {
                    own.hi = std::min(own.hi, (limit - start) / speed);
                } else if (speed < 0) {
                    own.lo = std::max(own.lo, (limit - start) / speed);
                } else if (start > limit) {
                    continue;
                }
                if (own.lo <= own.hi) {
                    inside = {std::min(inside.lo, own.lo), std::max(inside.hi, own.hi)};
                }
            }
            if (!(inside.lo < inside.hi)) {
                return std::nullopt;
            }
            depths = inside;
        }
    }
    return depths;
}

// The longest of nine paths, and a little more, because those between may be longer. What is left beyond a
// path's own end is for generate_tool_points.comp, which says the same of each sample.
SweptPatches::Interval SweptPatches::beforeCrossing(const Quad& quad, Interval depths) const {
    const float nearest = std::clamp(0.0F, depthLo_, depthHi_);
    const auto start = [&](std::size_t n) { return glm::vec3(quad[n].start + nearest * quad[n].direction); };
    const auto way = [&](std::size_t n) { return glm::vec3(quad[n].direction); };
    const std::array<glm::vec3, 2> startU{start(1) - start(0), start(3) - start(2)};
    const std::array<glm::vec3, 2> startV{start(2) - start(0), start(3) - start(1)};
    const std::array<glm::vec3, 2> wayU{way(1) - way(0), way(3) - way(2)};
    const std::array<glm::vec3, 2> wayV{way(2) - way(0), way(3) - way(1)};
    const auto longer = [](const std::array<glm::vec3, 2>& pair) {
        return std::max(glm::dot(pair[0], pair[0]), glm::dot(pair[1], pair[1]));
    };
    const float farthest = std::max(std::abs(depths.lo - nearest), std::abs(depths.hi - nearest));
    if (4 * farthest * farthest * std::max(longer(wayU), longer(wayV)) <
        std::min(longer(startU), longer(startV))) {
        return depths; // too shallow to meet
    }
    const glm::vec3 middleU = startU[0] + startU[1];
    const glm::vec3 middleV = startV[0] + startV[1];
    const glm::vec3 middleWay = way(0) + way(1) + way(2) + way(3);
    const float forwards = glm::dot(glm::cross(middleU, middleV), middleWay) < 0 ? -1.0F : 1.0F;
    Reach longest{0, 0};
    for (int n = 0; n < 9; ++n) {
        const glm::ivec2 place(n % 3, n / 3);
        const glm::vec2 uv = 0.5F * glm::vec2(place);
        const glm::vec3 direction =
            glm::mix(glm::mix(way(0), way(1), uv.x), glm::mix(way(2), way(3), uv.x), uv.y);
        const glm::vec3 u = glm::mix(startU[0], startU[1], uv.y);
        const glm::vec3 v = glm::mix(startV[0], startV[1], uv.x);
        const glm::vec3 du = glm::mix(wayU[0], wayU[1], uv.y);
        const glm::vec3 dv = glm::mix(wayV[0], wayV[1], uv.x);
        const float volume = forwards * glm::dot(glm::cross(u, v), direction);
        const float alongU = glm::dot(u, middleU);
        const float alongV = glm::dot(v, middleV);
        if (!(volume > 0 && alongU > 0 && alongV > 0)) {
            return depths; // folded from the beginning: nothing is known
        }
        Reach reach;
        endAtRoots(reach, volume, forwards * glm::dot(glm::cross(u, dv) + glm::cross(du, v), direction),
                   forwards * glm::dot(glm::cross(du, dv), direction));
        endAtRoots(reach, alongU, glm::dot(du, middleU), 0);
        endAtRoots(reach, alongV, glm::dot(dv, middleV), 0);
        longest = {std::min(longest.back, reach.back), std::max(longest.forth, reach.forth)};
    }
    constexpr float kMargin = 1.05F;
    const float least = kSpacing / std::max(glm::length(middleWay) / 4, 1e-6F);
    return {std::max(depths.lo, nearest + kMargin * longest.back - least),
            std::min(depths.hi, nearest + kMargin * longest.forth + least)};
}

std::optional<SweptPatches::Interval> SweptPatches::usefulDepths(const Quad& quad, Interval depths) const {
    const auto inBox = clipped(quad, depths);
    const bool isParallel = std::all_of(quad.begin() + 1, quad.end(), [&](const SweptCorner& corner) {
        return corner.direction == quad[0].direction;
    });
    if (!inBox || isParallel || orientation_ != 0) {
        return inBox;
    }
    const Interval rest = beforeCrossing(quad, *inBox);
    return rest.lo < rest.hi ? std::optional(rest) : std::nullopt;
}

void SweptPatches::addPart(Part part) {
    const Quad corners = quad(part.corners);
    if (part.isBilinear) {
        const auto mask = [&](std::size_t n) { return corners[n].start.w; };
        const float sum = mask(0) + mask(1) + mask(2) + mask(3);
        if (!(sum > 0)) {
            return;
        }
        part.mean = sum / 4;
        part.centroid = glm::vec2(mask(1) + mask(3), mask(2) + mask(3)) / sum;
    }
    const auto useful = usefulDepths(corners, part.depths);
    if (!useful) {
        return;
    }
    part.depths = *useful;
    std::array<glm::vec3, 4> begin;
    std::array<glm::vec3, 4> end;
    glm::vec3 direction(0);
    float longest = 0;
    for (std::size_t n = 0; n < 4; ++n) {
        const glm::vec3 along = density_ * glm::vec3(corners[n].direction);
        begin[n] = density_ * glm::vec3(corners[n].start) + useful->lo * along;
        end[n] = density_ * glm::vec3(corners[n].start) + useful->hi * along;
        direction += along;
        longest = std::max(longest, glm::dot(along, along));
    }
    const float squared = std::max(glm::dot(direction, direction), 1e-12F);
    const auto gap = [&](std::size_t a, std::size_t b) {
        return std::max(gapSquared(begin[b] - begin[a], direction, squared),
                        gapSquared(end[b] - end[a], direction, squared));
    };
    const float u = samplesFor(std::max(gap(0, 1), gap(2, 3)));
    const float v = samplesFor(std::max(gap(0, 2), gap(1, 3)));
    const float depth = useful->hi - useful->lo;
    const float d = samplesFor(longest * depth * depth);
    const bool isSmall = u <= float(kMaxAcross) && v <= float(kMaxAcross) && d <= float(kMaxAlong) &&
                         u * v * d <= float(kMaxPatchPoints);
    if (!isSmall && part.level < kMaxLevel && std::isfinite(u * v * d)) {
        ++part.level;
        if (d >= std::max(u, v)) {
            splitAlongDepth(part);
        } else {
            splitAcross(part, u >= v ? 0 : 1);
        }
        return;
    }
    for (std::size_t n = 0; n < 4; ++n) {
        lo_ = glm::min(lo_, glm::min(begin[n], end[n]) / density_);
        hi_ = glm::max(hi_, glm::max(begin[n], end[n]) / density_);
    }
    const int nu = clampCount(u, kMaxAcross);
    const int nv = clampCount(v, kMaxAcross);
    const int nd = clampCount(d, kMaxPatchPoints / (nu * nv));
    const float mask = part.isBilinear && nu * nv > 1 ? -1 : part.mean;
    const glm::vec2 offset(nu == 1 ? part.centroid.x - 0.5F : 0.0F, nv == 1 ? part.centroid.y - 0.5F : 0.0F);
    patches_.push_back({part.corners, std::uint32_t(pointCount_),
                        std::uint32_t(nu) | std::uint32_t(nv) << 8U | std::uint32_t(nd) << 16U, mask,
                        glm::packSnorm2x16(offset), useful->lo, useful->hi});
    pointCount_ += std::size_t(nu) * std::size_t(nv) * std::size_t(nd);
}

SweptPatches::Some SweptPatches::patchesIn(const Box3& voxels) const {
    const glm::vec3 lo = glm::vec3(voxels.lo) - 1.0F;
    const glm::vec3 hi(voxels.hi);
    Some some;
    for (const SweptPatch& patch : patches_) {
        glm::vec3 least(1e30F);
        glm::vec3 most(-1e30F);
        for (const std::uint32_t n : patch.corners) {
            for (const float depth : {patch.depthLo, patch.depthHi}) {
                const glm::vec3 p(corners_[n].start + depth * corners_[n].direction);
                least = glm::min(least, p);
                most = glm::max(most, p);
            }
        }
        if (glm::any(glm::lessThan(most, lo)) || glm::any(glm::greaterThan(least, hi))) {
            continue;
        }
        const std::uint32_t count =
            (patch.counts & 0xFFU) * (patch.counts >> 8U & 0xFFU) * (patch.counts >> 16U);
        some.patches.push_back(patch);
        some.patches.back().firstPoint = std::uint32_t(some.pointCount);
        some.pointCount += count;
    }
    return some;
}

void SweptPatches::splitAlongDepth(const Part& part) {
    const float middle = 0.5F * (part.depths.lo + part.depths.hi);
    Part half = part;
    half.depths.hi = middle;
    addPart(half);
    half.depths = {middle, part.depths.hi};
    addPart(half);
}

void SweptPatches::splitAcross(const Part& part, int axis) {
    // The corners of a part of a bilinear patch are its values there.
    const auto between = [&](std::size_t a, std::size_t b) {
        const SweptCorner& from = corners_[part.corners[a]];
        const SweptCorner& to = corners_[part.corners[b]];
        corners_.push_back({0.5F * (from.start + to.start), 0.5F * (from.direction + to.direction)});
        return std::uint32_t(corners_.size() - 1);
    };
    const auto& c = part.corners;
    const std::uint32_t low = axis == 0 ? between(0, 1) : between(0, 2);
    const std::uint32_t high = axis == 0 ? between(2, 3) : between(1, 3);
    Part half = part;
    half.centroid[axis] = 0.5F;
    half.corners = axis == 0 ? std::array{c[0], low, c[2], high} : std::array{c[0], c[1], low, high};
    addPart(half);
    half.corners = axis == 0 ? std::array{low, c[1], high, c[3]} : std::array{low, high, c[2], c[3]};
    addPart(half);
}

Box3 SweptPatches::pointBox() const { return patches_.empty() ? Box3{} : voxelsBetween(lo_, hi_); }

Box3 SweptPatches::hullBox(float depthLo, float depthHi) const {
    glm::vec3 lo(1e30F);
    glm::vec3 hi(-1e30F);
    for (const Part& part : noted_) {
        for (const std::uint32_t corner : part.corners) {
            const glm::vec3 begin(corners_[corner].start + depthLo * corners_[corner].direction);
            const glm::vec3 end(corners_[corner].start + depthHi * corners_[corner].direction);
            lo = glm::min(lo, glm::min(begin, end));
            hi = glm::max(hi, glm::max(begin, end));
        }
    }
    return noted_.empty() ? Box3{} : voxelsBetween(lo, hi);
}

Box3 SweptPatches::voxelsBetween(const glm::vec3& lo, const glm::vec3& hi) {
    // Far outside every grid is as good as infinitely far, and safe to convert.
    const glm::vec3 first = glm::clamp(lo, glm::vec3(-1e6F), glm::vec3(1e6F));
    const glm::vec3 last = glm::clamp(hi, glm::vec3(-1e6F), glm::vec3(1e6F));
    return {glm::ivec3(glm::floor(first + 0.5F)), glm::ivec3(glm::floor(last + 0.5F)) + 1};
}

} // namespace vs::sculpt
