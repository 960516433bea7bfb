// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/wall_voxels.h"

#include "base/parallel.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>

namespace vs::segment {
namespace {

// What is worth looking at from one station.
struct Shell {
    std::array<double, kRays> lo{}, hi{}; // distances from the axis by ray; none where hi is 0
    double farthest = 0;
    bool isEmpty() const { return farthest <= 0; }
};

// The shell reaches as far as the nearest voxels on both sides may lie, and a little further, since the wall
// is known by half a voxel only. Rays beside an open one are open too: the wall bends away there.
Shell shellOf(const Lumen& lumen, const Station& station, const Outline& outline) {
    Shell shell;
    if (outline.typicalMm <= 0) {
        return shell;
    }
    for (std::size_t i = 0; i < kRays; ++i) {
        if (outline.isOpen[i] || outline.isOpen[(i + 1) % kRays] || outline.isOpen[(i + kRays - 1) % kRays]) {
            continue;
        }
        const double band = 1.2 * lumen.apartMm(rayOf(station, i)) + 0.3 * lumen.stepMm;
        shell.lo[i] = outline.radiiMm[i] - band;
        shell.hi[i] = outline.radiiMm[i] + band;
        shell.farthest = std::max(shell.farthest, shell.hi[i]);
    }
    return shell;
}

// The range of x in which a voxel of a row lies between two planes.
class RowRange {
public:
    RowRange(int lo, int end) : lo_(lo), hi_(end - 1) {}
    // Keeps where value + slope x >= 0.
    void keepPositive(double value, double slope) {
        if (slope > 1e-12) {
            lo_ = std::max(lo_, std::ceil(-value / slope - 1e-9));
        } else if (slope < -1e-12) {
            hi_ = std::min(hi_, std::floor(-value / slope + 1e-9));
        } else if (value < 0) {
            hi_ = lo_ - 1;
        }
    }
    // Both are in the row, or the last is before the first.
    [[nodiscard]] int first() const { return lo_ <= hi_ ? int(lo_) : 0; }
    [[nodiscard]] int last() const { return lo_ <= hi_ ? int(hi_) : -1; }

private:
    double lo_, hi_;
};

// Looks at the voxels between two neighbouring stations.
class Slab {
public:
    Slab(const Lumen& lumen, const Station& before, const Station& after, const Shell& shell)
        : lumen_(lumen), before_(before), after_(after), shell_(shell) {}

    [[nodiscard]] std::vector<WallVoxel> voxels() const {
        std::vector<WallVoxel> found;
        const Box3 box = bounds();
        const glm::dvec3 step(lumen_.worldFromVoxel[0]);
        for (int z = box.lo.z; z < box.hi.z; ++z) {
            for (int y = box.lo.y; y < box.hi.y; ++y) {
                const glm::dvec3 row(lumen_.worldFromVoxel * glm::dvec4(0, y, z, 1));
                RowRange range(box.lo.x, box.hi.x);
                range.keepPositive(pastFirst(row), glm::dot(step, before_.tangent));
                range.keepPositive(-pastSecond(row), -glm::dot(step, after_.tangent));
                for (int x = range.first(); x <= range.last(); ++x) {
                    add({x, y, z}, row + double(x) * step, found);
                }
            }
        }
        return found;
    }

private:
    [[nodiscard]] double pastFirst(const glm::dvec3& place) const {
        return glm::dot(place - before_.place, before_.tangent);
    }
    [[nodiscard]] double pastSecond(const glm::dvec3& place) const {
        return glm::dot(place - after_.place, after_.tangent);
    }
    [[nodiscard]] Box3 bounds() const {
        const double reach = shell_.farthest + glm::distance(before_.place, after_.place);
        const glm::dvec3 middle = 0.5 * (before_.place + after_.place);
        const glm::dvec3 voxel(lumen_.voxelFromWorld * glm::dvec4(middle, 1));
        const glm::dmat3 rows = glm::transpose(glm::dmat3(lumen_.voxelFromWorld));
        const glm::dvec3 reaches =
            reach * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
        return intersect(
            {glm::ivec3(glm::floor(voxel - reaches)), glm::ivec3(glm::ceil(voxel + reaches)) + 1},
            {glm::ivec3(0), lumen_.gridDims});
    }
    void add(glm::ivec3 voxel, const glm::dvec3& place, std::vector<WallVoxel>& found) const {
        const double past = pastFirst(place);
        const double left = -pastSecond(place);
        const double part = past + left > 0 ? past / (past + left) : 0;
        const glm::dvec3 offset = place - glm::mix(before_.place, after_.place, part);
        const double x = glm::dot(offset, glm::mix(before_.across, after_.across, part));
        const double y = glm::dot(offset, glm::mix(before_.up, after_.up, part));
        const double radius = std::sqrt(x * x + y * y);
        if (radius > shell_.farthest || radius <= 0) {
            return;
        }
        const double turns = std::atan2(y, x) / glm::two_pi<double>() + 1;
        const auto ray = std::size_t(std::lround(turns * double(kRays))) % kRays;
        if (radius < shell_.lo[ray] || radius > shell_.hi[ray]) {
            return;
        }
        const bool isInside = lumen_.voxels.contains(voxel);
        const double along = glm::mix(before_.alongMm, after_.alongMm, part);
        found.push_back({along, radius, x / radius, y / radius, isInside, voxel, ray});
    }

    const Lumen& lumen_;
    const Station& before_;
    const Station& after_;
    const Shell& shell_;
};

} // namespace

std::vector<Outline> outlinesAlong(const Lumen& lumen, const Curve& curve,
                                   const std::vector<double>& radiiMm) {
    std::vector<Outline> outlines(curve.size());
    inParallel(int(curve.size()), [&](int station) {
        const auto i = std::size_t(station);
        if (lumen.contains(curve[i].place)) {
            outlines[i] =
                outlineAround(lumen, curve[i], 3 * radiiMm[i] + 2 * lumen.coarseMm, Where::InTheMiddle);
        }
    });
    return outlines;
}

WallVoxels wallVoxels(const Lumen& lumen, const Curve& curve, const std::vector<Outline>& outlines) {
    WallVoxels found(curve.size() - 1);
    inParallel(int(found.size()), [&](int station) {
        const auto i = std::size_t(station);
        const Shell before = shellOf(lumen, curve[i], outlines[i]);
        const Shell after = shellOf(lumen, curve[i + 1], outlines[i + 1]);
        if (!before.isEmpty() && !after.isEmpty()) {
            found[i] = Slab(lumen, curve[i], curve[i + 1], before).voxels();
        }
    });
    return found;
}

} // namespace vs::segment
