// SPDX-License-Identifier: Apache-2.0
#include "marking/laying.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_set>

namespace vs::marking {

namespace {

constexpr int kBlock = 4; // texels along a side of what is looked at together
constexpr int kBits = 21; // of a block's number along an axis
constexpr std::uint64_t kMask = (std::uint64_t(1) << kBits) - 1;

std::uint64_t keyOf(glm::ivec3 block) {
    return std::uint64_t(block.z) << (2 * kBits) | std::uint64_t(block.y) << kBits | std::uint64_t(block.x);
}

glm::ivec3 blockOf(std::uint64_t key) {
    return {int(key & kMask), int(key >> kBits & kMask), int(key >> (2 * kBits))};
}

// Coverage so far inside an edge.
double coverageAt(double insideMm, double texelMm) { return 0.5 + insideMm / (field::kMarkRamp * texelMm); }

class Laying {
public:
    Laying(MarkLayer& layer, const Ground& ground, const Shape& shape, const Rim& rim)
        : layer_(layer), ground_(ground), shape_(shape), rim_(rim), grid_(layer.grid()),
          voxelFromWorld_(ground.geometry->voxelFromWorld()),
          // Thinner than this, and no texel would be covered.
          depthMm_(std::max(rim.depthMm, 0.75 * grid_.texelMm)),
          rampMm_(0.5 * field::kMarkRamp * grid_.texelMm) {}

    // The blocks about the surface, in order.
    [[nodiscard]] std::set<std::uint64_t> blocks(glm::ivec2 lo, glm::ivec2 hi) const {
        std::unordered_set<std::uint64_t> onSurface;
        double widest = 0; // of pixels that show the shape, where they lie
        for (int y = lo.y; y < hi.y; ++y) {
            for (int x = lo.x; x < hi.x; ++x) {
                const ReliefPoint* point = ground_.relief->at({x, y});
                if (point == nullptr) {
                    continue;
                }
                const ReliefPoint* beside = ground_.relief->at({x + 1, y});
                const double apart = beside != nullptr ? glm::distance(beside->world, point->world) : 0;
                const double slack = rampMm_ + std::min(apart, 4 * grid_.texelMm);
                if (shape_(point->world, {x + 0.5, y + 0.5}).insideMm > -slack) {
                    widest = std::max(widest, std::min(apart, depthMm_ + rampMm_));
                    onSurface.insert(keyOf(blockAt(point->world)));
                }
            }
        }
        return around(onSurface, depthMm_ + rampMm_ + widest);
    }

    void cover(std::uint64_t block) {
        const glm::ivec3 first = blockOf(block) * kBlock;
        forEachVoxel({first, glm::min(first + kBlock, grid_.texels())},
                     [&](glm::ivec3 texel, std::size_t) { coverTexel(texel); });
    }

private:
    [[nodiscard]] glm::ivec3 blockAt(const glm::dvec3& world) const {
        const glm::dvec3 voxel(voxelFromWorld_ * glm::dvec4(world, 1));
        const glm::ivec3 texel(glm::round(grid_.texelFromVoxel(voxel)));
        return glm::clamp(texel, glm::ivec3(0), grid_.texels() - 1) / kBlock;
    }

    [[nodiscard]] std::set<std::uint64_t> around(const std::unordered_set<std::uint64_t>& blocks,
                                                 double reachMm) const {
        const glm::dvec3 texelMm = ground_.geometry->spacing() / glm::dvec3(grid_.perVoxel);
        const glm::ivec3 reach(glm::ceil(reachMm / texelMm / double(kBlock)));
        const glm::ivec3 last = (grid_.texels() - 1) / kBlock;
        std::set<std::uint64_t> all;
        for (const std::uint64_t key : blocks) {
            const glm::ivec3 block = blockOf(key);
            forEachVoxel({glm::max(block - reach, glm::ivec3(0)), glm::min(block + reach, last) + 1},
                         [&](glm::ivec3 there, std::size_t) { all.insert(keyOf(there)); });
        }
        return all;
    }

    void coverTexel(glm::ivec3 texel) {
        const glm::dvec3 world(ground_.geometry->worldFromVoxel * glm::dvec4(grid_.voxelFromTexel(texel), 1));
        const glm::dvec2 pixel = ground_.pixelOf(world);
        const ReliefPoint* point = ground_.relief->nearest(pixel, world);
        if (point == nullptr) {
            return;
        }
        const double above = glm::dot(world - point->world, point->normal);
        const double within = coverageAt(depthMm_ - std::abs(above), grid_.texelMm);
        if (within <= 0) {
            return;
        }
        const OnLine on = shape_(world - above * point->normal, pixel);
        const double coverage = std::min(within, coverageAt(on.insideMm, grid_.texelMm));
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
    double depthMm_;
    double rampMm_;
};

} // namespace

void lay(MarkLayer& layer, const Ground& ground, const Shape& shape, const Rim& rim, glm::ivec2 lo,
         glm::ivec2 hi) {
    Laying laying(layer, ground, shape, rim);
    for (const std::uint64_t block : laying.blocks(lo, hi)) {
        laying.cover(block);
    }
}

} // namespace vs::marking
