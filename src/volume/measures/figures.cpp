// SPDX-License-Identifier: Apache-2.0
#include "volume/measures/figures.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vs::volume {

namespace {

// Where a line along the first coordinate crosses the outline's edges, in order: between the first and the
// second crossing one is inside, and so on. A vertex counts to the edge that begins above it alone.
std::vector<double> crossings(std::span<const glm::dvec2> outline, double y) {
    std::vector<double> found;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i];
        const glm::dvec2 b = outline[(i + 1) % outline.size()];
        if ((a.y <= y) != (b.y <= y)) {
            found.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

struct Sums {
    std::size_t voxels = 0;
    double shift = 0; // the first value: sums about it do not cancel
    double sum = 0;
    double squares = 0;
    double smallest = std::numeric_limits<double>::infinity();
    double largest = -std::numeric_limits<double>::infinity();

    void add(double value) {
        if (!std::isfinite(value)) {
            return;
        }
        shift = voxels == 0 ? value : shift;
        ++voxels;
        sum += value - shift;
        squares += (value - shift) * (value - shift);
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
    }
};

// Calls `visit` with each voxel of the slice whose centre the outline encloses.
template <typename Visit>
void visitEnclosed(std::span<const glm::dvec3> outline, int axis, glm::ivec3 dims, const Visit& visit) {
    const int across = (axis + 1) % 3;
    const int down = (axis + 2) % 3;
    const int slice = int(std::lround(outline.front()[axis]));
    if (slice < 0 || slice >= dims[axis]) {
        return;
    }
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& point : outline) {
        flat.emplace_back(point[across], point[down]);
    }
    const auto [least, most] = std::minmax_element(
        flat.begin(), flat.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    const int firstRow = std::max(int(std::ceil(std::max(least->y, 0.0))), 0);
    const int lastRow = std::min(int(std::floor(std::min(most->y, double(dims[down])))), dims[down] - 1);
    for (int row = firstRow; row <= lastRow; ++row) {
        const auto ends = crossings(flat, row);
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            const int first = std::max(int(std::ceil(ends[i])), 0);
            const int end = std::min(int(std::ceil(ends[i + 1])), dims[across]);
            for (int column = first; column < end; ++column) {
                glm::ivec3 voxel(slice);
                voxel[across] = column;
                voxel[down] = row;
                visit(voxel);
            }
        }
    }
}

double polygonMm2(const GridGeometry& geometry, std::span<const glm::dvec3> outline) {
    const glm::dmat3 worldFromVoxel(geometry.worldFromVoxel);
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        sum += glm::cross(worldFromVoxel * (outline[i] - outline[0]),
                          worldFromVoxel * (outline[i + 1] - outline[0]));
    }
    return 0.5 * glm::length(sum);
}

} // namespace

double lengthMm(std::span<const glm::dvec3> world) {
    double length = 0;
    for (std::size_t i = 1; i < world.size(); ++i) {
        length += glm::distance(world[i - 1], world[i]);
    }
    return length;
}

double angleDegrees(glm::dvec3 world, glm::dvec3 corner, glm::dvec3 other) {
    const glm::dvec3 a = world - corner;
    const glm::dvec3 b = other - corner;
    // By sine and cosine: exact for small angles too.
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

int sliceAxis(std::span<const glm::dvec3> outline) {
    constexpr double kApart = 0.01; // voxels
    for (int axis = 2; axis >= 0; --axis) {
        const bool isOne = std::all_of(outline.begin(), outline.end(), [&](const glm::dvec3& point) {
            return std::abs(point[axis] - outline.front()[axis]) <= kApart;
        });
        if (isOne) {
            return axis;
        }
    }
    return -1;
}

UnderOutline underOutline(const Volume& volume, std::span<const glm::dvec3> outline) {
    const int axis = sliceAxis(outline);
    VS_CHECK(axis >= 0 && outline.size() >= 3);
    UnderOutline under;
    under.mm2 = polygonMm2(volume.geometry, outline);
    Sums sums;
    visitEnclosed(outline, axis, volume.geometry.dims, [&](glm::ivec3 voxel) { sums.add(volume.at(voxel)); });
    if (sums.voxels > 0) {
        const auto n = double(sums.voxels);
        const double offset = sums.sum / n;
        under.voxels = sums.voxels;
        under.mean = sums.shift + offset;
        under.deviation = std::sqrt(std::max(sums.squares / n - offset * offset, 0.0));
        under.smallest = sums.smallest;
        under.largest = sums.largest;
    }
    return under;
}

} // namespace vs::volume
