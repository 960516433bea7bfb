// SPDX-License-Identifier: Apache-2.0
#include "marking/laying.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vs::marking {

namespace {

constexpr int kBlock = 4; // texels along a side of what is looked at together

// Which blocks of a box are meant.
class BlockMap {
public:
    BlockMap() = default;
    explicit BlockMap(const Box3& box) : box_(box), isIn_(box.volume()) {}

    void set(glm::ivec3 block) { isIn_[indexOf(block)] = 1; }
    // Means all within so many of one that is meant, axis after axis.
    void widen(glm::ivec3 reach) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 size = box_.size();
            const int count = size[axis];
            size[axis] = 1; // where lines along the axis begin
            forEachVoxel({box_.lo, box_.lo + size},
                         [&](glm::ivec3 begin, std::size_t) { widenLine(begin, axis, count, reach[axis]); });
        }
    }
    template <typename Visit>
    void forEach(const Visit& visit) const {
        forEachVoxel(box_, [&](glm::ivec3 block, std::size_t i) {
            if (isIn_[i] != 0) {
                visit(block);
            }
        });
    }

private:
    void widenLine(glm::ivec3 begin, int axis, int count, int reach) {
        std::vector<int> passed(std::size_t(count), reach + 1); // blocks since the last one that is meant
        const auto at = [&](int n) {
            glm::ivec3 block = begin;
            block[axis] += n;
            return indexOf(block);
        };
        int since = reach + 1;
        for (int n = 0; n < count; ++n) {
            since = isIn_[at(n)] != 0 ? 0 : since + 1;
            passed[std::size_t(n)] = since;
        }
        since = reach + 1;
        for (int n = count - 1; n >= 0; --n) {
            since = passed[std::size_t(n)] == 0 ? 0 : since + 1;
            isIn_[at(n)] = std::min(since, passed[std::size_t(n)]) <= reach ? 1 : 0;
        }
    }
    [[nodiscard]] std::size_t indexOf(glm::ivec3 block) const {
        const glm::ivec3 at = block - box_.lo;
        const glm::ivec3 n = box_.size();
        return (std::size_t(at.z) * std::size_t(n.y) + std::size_t(at.y)) * std::size_t(n.x) +
               std::size_t(at.x);
    }

    Box3 box_;
    std::vector<std::uint8_t> isIn_;
};

// Coverage so far inside an edge.
double coverageAt(double insideMm, double texelMm) { return 0.5 + insideMm / (field::kMarkRamp * texelMm); }

class Laying {
public:
    Laying(MarkLayer& layer, const Ground& ground, const Shape& shape, const Rim& rim)
        : layer_(layer), ground_(ground), shape_(shape), rim_(rim), grid_(layer.grid()),
          voxelFromWorld_(ground.geometry->voxelFromWorld()), texelMm_(grid_.texelMm(*ground.geometry)),
          // Thinner than this, and no texel would be covered.
          depthMm_(std::max(rim.depthMm, 0.75 * texelMm_)), rampMm_(0.5 * field::kMarkRamp * texelMm_) {}

    // The blocks about the surface.
    [[nodiscard]] BlockMap blocks(glm::ivec2 lo, glm::ivec2 hi) const {
        std::vector<glm::ivec3> onSurface;
        double widest = 0; // of what lies between places that are looked at
        const int stride = strideIn(lo, hi);
        for (int y = lo.y; y < hi.y; y += stride) {
            for (int x = lo.x; x < hi.x; x += stride) {
                const ReliefPoint* point = ground_.relief->at({x, y});
                if (point == nullptr) {
                    continue;
                }
                const ReliefPoint* beside = ground_.relief->at({x + stride, y});
                const double apart = beside != nullptr ? glm::distance(beside->world, point->world) : 0;
                const double slack = rampMm_ + std::min(apart, 4 * texelMm_);
                if (shape_(point->world, {x + 0.5, y + 0.5}).insideMm > -slack) {
                    widest = std::max(widest, std::min(apart, depthMm_ + rampMm_));
                    onSurface.push_back(blockAt(point->world));
                }
            }
        }
        return around(onSurface, depthMm_ + rampMm_ + widest);
    }

    void cover(glm::ivec3 block) {
        const glm::ivec3 first = block * kBlock;
        forEachVoxel({first, glm::min(first + kBlock, grid_.texels())},
                     [&](glm::ivec3 texel, std::size_t) { coverTexel(texel); });
    }

private:
    [[nodiscard]] glm::ivec3 blockAt(const glm::dvec3& world) const {
        const glm::dvec3 voxel(voxelFromWorld_ * glm::dvec4(world, 1));
        const glm::ivec3 texel(glm::round(grid_.texelFromVoxel(voxel)));
        return glm::clamp(texel, glm::ivec3(0), grid_.texels() - 1) / kBlock;
    }

    // From near, pixels are much smaller than texels: some of them say which blocks lie there.
    [[nodiscard]] int strideIn(glm::ivec2 lo, glm::ivec2 hi) const {
        constexpr int most = 16;
        const glm::ivec2 middle = (lo + hi) / 2;
        const ReliefPoint* point = ground_.relief->at(middle);
        const ReliefPoint* beside = ground_.relief->at(middle + glm::ivec2(1, 0));
        if (point == nullptr || beside == nullptr) {
            return 1;
        }
        const double apart = std::max(glm::distance(point->world, beside->world), 1e-9 * texelMm_);
        return int(std::clamp(2 * texelMm_ / apart, 1.0, double(most)));
    }

    // All blocks within reach of these, along each axis.
    [[nodiscard]] BlockMap around(const std::vector<glm::ivec3>& blocks, double reachMm) const {
        if (blocks.empty()) {
            return {};
        }
        const glm::dvec3 blockMm = ground_.geometry->spacing() / glm::dvec3(grid_.perVoxel) * double(kBlock);
        const glm::ivec3 last = (grid_.texels() - 1) / kBlock;
        const glm::ivec3 reach(glm::min(glm::ceil(reachMm / blockMm), glm::dvec3(last + 1)));
        Box3 box{blocks.front(), blocks.front() + 1};
        for (const glm::ivec3& block : blocks) {
            box = unite(box, {block, block + 1});
        }
        BlockMap map(intersect({box.lo - reach, box.hi + reach}, {glm::ivec3(0), last + 1}));
        for (const glm::ivec3& block : blocks) {
            map.set(block);
        }
        map.widen(reach);
        return map;
    }

    void coverTexel(glm::ivec3 texel) {
        const glm::dvec3 world(ground_.geometry->worldFromVoxel * glm::dvec4(grid_.voxelFromTexel(texel), 1));
        const glm::dvec2 pixel = ground_.pixelOf(world);
        const ReliefPoint* point = ground_.relief->nearest(pixel, world);
        if (point == nullptr) {
            return;
        }
        const double above = glm::dot(world - point->world, point->normal);
        const double within = coverageAt(depthMm_ - std::abs(above), texelMm_);
        if (within <= 0) {
            return;
        }
        const OnLine on = shape_(world - above * point->normal, pixel);
        const double coverage = std::min(within, coverageAt(on.insideMm, texelMm_));
        if (coverage > 0) {
            layer_.cover(texel, coverage, on.opacity * hardness(on.insideMm));
        }
    }

    [[nodiscard]] double hardness(double insideMm) const {
        const double part = rim_.softMm > 0 ? std::clamp(insideMm / rim_.softMm, 0.0, 1.0) : 1;
        return part * part * (3 - 2 * part);
    }

    MarkLayer& layer_;
    const Ground& ground_;
    const Shape& shape_;
    const Rim& rim_;
    const field::MarkGrid& grid_;
    glm::dmat4 voxelFromWorld_;
    double texelMm_;
    double depthMm_;
    double rampMm_;
};

} // namespace

void lay(MarkLayer& layer, const Ground& ground, const Shape& shape, const Rim& rim, glm::ivec2 lo,
         glm::ivec2 hi) {
    Laying laying(layer, ground, shape, rim);
    laying.blocks(lo, hi).forEach([&](glm::ivec3 block) { laying.cover(block); });
}

} // namespace vs::marking
