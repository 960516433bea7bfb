// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/projection.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

// Bilinear between elements, zero outside the raster.
double sampleMask(const MaskRaster& mask, const glm::dvec2& place) {
    const glm::dvec2 element = (place - mask.origin) / mask.pitch;
    const glm::dvec2 base = glm::floor(element);
    if (base.x < 0 || base.y < 0 || base.x + 1 >= mask.size.x || base.y + 1 >= mask.size.y) {
        return 0;
    }
    const int i = int(base.x);
    const int j = int(base.y);
    const glm::dvec2 f = element - base;
    return glm::mix(glm::mix<double>(mask.at(i, j), mask.at(i + 1, j), f.x),
                    glm::mix<double>(mask.at(i, j + 1), mask.at(i + 1, j + 1), f.x), f.y);
}

// A place of the mask as a plane.
struct Template {
    MaskFrame frame;
    glm::dvec3 normal;

    explicit Template(const MaskFrame& f) : frame(f), normal(glm::cross(f.x, f.y)) {}
    [[nodiscard]] double height(const glm::dvec3& p) const { return glm::dot(p - frame.origin, normal); }
    [[nodiscard]] glm::dvec2 inPlane(const glm::dvec3& p) const {
        return {glm::dot(p - frame.origin, frame.x), glm::dot(p - frame.origin, frame.y)};
    }
};

// The region between two successive places of the mask.
class Slab {
public:
    Slab(const MaskRaster& mask, const PathPiece& piece) : mask_(mask), from_(piece.from), to_(piece.to) {}

    // The value at a point (in steps) of the slab or outside it.
    [[nodiscard]] double at(const glm::dvec3& p) const {
        constexpr double kOnPlane = 1e-9; // steps: what lies on a plane belongs to both sides
        if (from_.height(p) < -kOnPlane || to_.height(p) > kOnPlane) {
            return 0;
        }
        const double above = std::max(from_.height(p), 0.0);
        const double below = std::max(-to_.height(p), 0.0);
        // The direction in which the element at the foot of the point moves.
        const glm::dvec2 foot = from_.inPlane(p);
        const glm::dvec3 way = to_.frame.place(foot) - from_.frame.place(foot);
        const double leaves = glm::dot(way, from_.normal);
        const double arrives = glm::dot(way, to_.normal);
        if (!(leaves > 0 && arrives > 0)) {
            return 0;
        }
        const double back = above / leaves;
        const double forth = below / arrives;
        const double t = back + forth > 0 ? back / (back + forth) : 0;
        return glm::mix(sampleMask(mask_, from_.inPlane(p - back * way)),
                        sampleMask(mask_, to_.inPlane(p + forth * way)), t);
    }

    // Voxels that may lie in the slab.
    [[nodiscard]] Box3 box(const glm::dvec3& voxelFromSteps) const {
        glm::dvec3 lo(1e30);
        glm::dvec3 hi(-1e30);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec2 element((corner & 1) != 0 ? mask_.size.x - 1 : 0,
                                     (corner & 2) != 0 ? mask_.size.y - 1 : 0);
            const MaskFrame& frame = (corner & 4) != 0 ? to_.frame : from_.frame;
            const glm::dvec3 p = voxelFromSteps * frame.place(mask_.origin + mask_.pitch * element);
            lo = glm::min(lo, glm::clamp(p, -1e6, 1e6));
            hi = glm::max(hi, glm::clamp(p, -1e6, 1e6));
        }
        return {glm::ivec3(glm::ceil(lo)), glm::ivec3(glm::floor(hi)) + 1};
    }

    // The part of a row of voxels from `start`, `way` apart, that is in the slab.
    [[nodiscard]] glm::ivec2 inside(const glm::dvec3& start, const glm::dvec3& way, glm::ivec2 part) const {
        const auto clip = [&](double height, double slope) { // height + n * slope >= 0
            if (std::abs(slope) < 1e-12) {
                part.y = height < 0 ? part.x : part.y;
            } else if (slope > 0) {
                part.x =
                    int(std::clamp<double>(std::floor(-height / slope), part.x, std::max(part.x, part.y)));
            } else {
                part.y =
                    int(std::clamp<double>(std::ceil(-height / slope) + 1, std::min(part.x, part.y), part.y));
            }
        };
        clip(from_.height(start), glm::dot(way, from_.normal));
        clip(-to_.height(start), -glm::dot(way, to_.normal));
        return part;
    }

private:
    const MaskRaster& mask_;
    Template from_;
    Template to_;
};

} // namespace

std::vector<float> projectSweep(const MaskRaster& mask, std::span<const PathPiece> path, glm::ivec3 dims,
                                const glm::dvec3& voxelFromSteps) {
    const Box3 grid{glm::ivec3(0), dims};
    const glm::dvec3 steps = 1.0 / voxelFromSteps;
    std::vector<float> values(grid.volume(), 0.0F);
    for (const PathPiece& piece : path) {
        const Slab slab(mask, piece);
        const Box3 box = intersect(slab.box(voxelFromSteps), grid);
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            for (int y = box.lo.y; y < box.hi.y; ++y) {
                const glm::ivec2 part =
                    slab.inside(steps * glm::dvec3(0, y, z), {steps.x, 0, 0}, {box.lo.x, box.hi.x});
                float* row =
                    &values[(std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x)];
                for (int x = part.x; x < part.y; ++x) {
                    row[x] = std::max(row[x], float(slab.at(steps * glm::dvec3(x, y, z))));
                }
            }
        }
    }
    return values;
}

} // namespace vs::sculpt
