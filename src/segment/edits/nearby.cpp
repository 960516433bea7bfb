// SPDX-License-Identifier: Apache-2.0
#include "segment/edits/nearby.h"

#include "base/parallel.h"
#include "segment/edits/separable.h"

#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

constexpr double kTie = 1 + 1e-6;
constexpr std::uint16_t kNoRun = std::numeric_limits<std::uint16_t>::max();

// Inner products of the steps along the index axes: the squared length in mm of an offset d is d . (G d).
glm::dmat3 metricOf(const volume::GridGeometry& geometry) {
    const glm::dmat3 steps(geometry.worldFromVoxel);
    return glm::transpose(steps) * steps;
}

VoxelSet nearbyPerpendicular(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    const auto size = set.box.size();
    std::vector<float> squared(set.inside.size());
    std::transform(set.inside.begin(), set.inside.end(), squared.begin(),
                   [](std::uint8_t inside) { return inside != 0 ? 0.0F : 1e30F; });
    for (int axis = 0; axis < 3; ++axis) {
        const int reach = std::min(reachOf(geometry, mm)[axis], size[axis] - 1);
        std::vector<float> parabola;
        for (int k = -reach; k <= reach; ++k) {
            const double distance = k * geometry.spacing()[axis];
            parabola.push_back(float(distance * distance));
        }
        filterAlong(axis, squared, size, parabola, 1e30F, [](float least, float neighbour, float offset) {
            const float sum = neighbour + offset;
            return sum < least ? sum : least;
        });
    }
    VoxelSet result = emptySet(set.box);
    const auto limit = float(mm * mm * kTie * kTie);
    std::transform(squared.begin(), squared.end(), result.inside.begin(),
                   [&](float value) { return std::uint8_t(value <= limit ? 1 : 0); });
    return result;
}

// Part of a ball around the origin: voxels (first ... first + more, y, z).
struct BallRow {
    int y, z, first;
    std::uint16_t more;
};

std::vector<BallRow> ballRows(const glm::dmat3& metric, glm::ivec3 reach, double mm) {
    std::vector<BallRow> rows;
    for (int z = -reach.z; z <= reach.z; ++z) {
        for (int y = -reach.y; y <= reach.y; ++y) {
            // Where a x^2 + 2 b x + c <= 0.
            const glm::dvec3 offset(0, y, z);
            const double a = metric[0][0];
            const double b = glm::dot(metric[0], offset);
            const double c = glm::dot(offset, metric * offset) - mm * mm * kTie * kTie;
            const double discriminant = b * b - a * c;
            if (discriminant < 0) {
                continue;
            }
            const int first = int(std::ceil((-b - std::sqrt(discriminant)) / a));
            const int last = int(std::floor((-b + std::sqrt(discriminant)) / a));
            if (first <= last) {
                rows.push_back({y, z, first, std::uint16_t(std::min(last - first, kNoRun - 1))});
            }
        }
    }
    return rows;
}

VoxelSet nearbySheared(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    const auto size = set.box.size();
    auto reach = reachOf(geometry, mm);
    reach.y = std::min(reach.y, size.y - 1);
    reach.z = std::min(reach.z, size.z - 1);
    const auto ball = ballRows(metricOf(geometry), reach, mm);
    // For each voxel of each row, padded by the reach: steps along x since the last voxel of the set.
    const std::size_t padded(size.x + 2 * reach.x);
    std::vector<std::uint16_t> since(padded * std::size_t(size.y) * std::size_t(size.z), kNoRun);
    const auto rowAt = [&](int y, int z) { return std::size_t(y) + std::size_t(size.y) * std::size_t(z); };
    inParallel(size.z, [&](int z) {
        for (int y = 0; y < size.y; ++y) {
            const std::uint8_t* const inside = set.inside.data() + rowAt(y, z) * std::size_t(size.x);
            std::uint16_t* const row = since.data() + rowAt(y, z) * padded;
            for (int x = reach.x; x < int(padded); ++x) {
                const std::uint16_t before = x > 0 ? row[x - 1] : kNoRun;
                const bool isInside = x - reach.x < size.x && inside[x - reach.x] != 0;
                row[x] = isInside ? std::uint16_t(0) : std::uint16_t(before < kNoRun ? before + 1 : kNoRun);
            }
        }
    });
    reportProgress();
    VoxelSet result = emptySet(set.box);
    inParallel(size.z, [&](int z) {
        for (int y = 0; y < size.y; ++y) {
            std::uint8_t* const inside = result.inside.data() + rowAt(y, z) * std::size_t(size.x);
            for (const BallRow& part : ball) {
                if (y + part.y < 0 || y + part.y >= size.y || z + part.z < 0 || z + part.z >= size.z) {
                    continue;
                }
                // Voxels first ... first + more from here hold one of the set: seen back from the last of
                // them.
                const std::uint16_t* const row =
                    since.data() + rowAt(y + part.y, z + part.z) * padded + reach.x + part.first + part.more;
                for (int x = 0; x < size.x; ++x) {
                    inside[x] |= std::uint8_t(row[x] <= part.more ? 1 : 0);
                }
            }
        }
    });
    return result;
}

} // namespace

bool isSheared(const volume::GridGeometry& geometry) {
    const glm::dmat3 metric = metricOf(geometry);
    const auto cosine = [&](int a, int b) { return metric[a][b] / std::sqrt(metric[a][a] * metric[b][b]); };
    // Headers store directions with few digits: less than this between axes is rounding.
    return std::max({std::abs(cosine(0, 1)), std::abs(cosine(0, 2)), std::abs(cosine(1, 2))}) > 1e-4;
}

glm::ivec3 reachOf(const volume::GridGeometry& geometry, double mm) {
    const glm::dmat3 voxelFromMm = glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel)));
    const glm::dvec3 perMm(glm::length(voxelFromMm[0]), glm::length(voxelFromMm[1]),
                           glm::length(voxelFromMm[2]));
    return glm::ivec3(glm::floor(mm * kTie * perMm));
}

VoxelSet nearby(const VoxelSet& set, const volume::GridGeometry& geometry, double mm) {
    if (set.box.isEmpty()) {
        return set;
    }
    return isSheared(geometry) ? nearbySheared(set, geometry, mm) : nearbyPerpendicular(set, geometry, mm);
}

} // namespace vs::segment
