// SPDX-License-Identifier: Apache-2.0
#include "field/marks/marks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vs::field {

MarkGrid markGridOf(const volume::GridGeometry& geometry) {
    constexpr int mostTexels = 1280; // along an axis that has steps for voxels
    const glm::dvec3 spacing = geometry.spacing();
    const double step = geometry.stepMm();
    const glm::dvec3 steps = glm::dvec3(geometry.dims) * spacing / step;
    const double longest = std::max({steps.x, steps.y, steps.z});
    const double perStep = 2 * longest <= mostTexels ? 2 : 1;
    const glm::dvec3 perVoxel =
        glm::clamp(glm::round(spacing / step * perStep), 1.0, double(kMostMarksPerVoxel));
    return {geometry.dims, glm::ivec3(perVoxel)};
}

bool MarkBrick::isEmpty() const {
    return std::all_of(coverage.begin(), coverage.end(), [](std::uint8_t covered) { return covered == 0; });
}

MarkTexel Marks::texelAt(glm::ivec3 texel) const {
    if (isEmpty() || glm::any(glm::lessThan(texel, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(texel, grid_.texels()))) {
        return {};
    }
    const MarkBrick* brick = find(grid_.placeOf(texel / kMarkBrick));
    return brick != nullptr ? brick->at(MarkBrick::index(texel % kMarkBrick)) : MarkTexel();
}

glm::dvec4 Marks::colourAt(const glm::dvec3& voxel) const {
    if (isEmpty()) {
        return glm::dvec4(0);
    }
    const glm::dvec3 q =
        glm::clamp(grid_.texelFromVoxel(voxel), glm::dvec3(0), glm::dvec3(grid_.texels() - 1));
    const glm::ivec3 first(glm::floor(q));
    const glm::dvec3 part = q - glm::dvec3(first);
    double covered = 0;
    glm::dvec4 sum(0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - part, part, glm::dvec3(offset));
        const MarkTexel texel = texelAt(first + offset);
        const double weight = w.x * w.y * w.z * texel.coverage / 255.0;
        sum += weight / 255 * glm::dvec4(texel.red, texel.green, texel.blue, texel.opacity);
        covered += weight;
    }
    const double inside = std::clamp((covered - 0.5) * kMarkRamp + 0.5, 0.0, 1.0);
    return covered > 0 ? glm::dvec4(glm::dvec3(sum) / covered, sum.w / covered * inside) : glm::dvec4(0);
}

bool Marks::operator==(const Marks& other) const {
    return (isEmpty() && other.isEmpty()) || (grid_ == other.grid_ && bricks_ == other.bricks_);
}

std::vector<std::array<std::uint8_t, 4>> coloursOfVoxels(const Marks& marks) {
    const MarkGrid& grid = marks.grid();
    const glm::ivec3 n = grid.dims;
    std::vector<std::array<std::uint8_t, 4>> colours(std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z));
    const double perVoxel = double(grid.perVoxel.x) * grid.perVoxel.y * grid.perVoxel.z;
    std::map<std::size_t, glm::dvec4> sums; // of voxels with marks: colours by their opacity, and that
    for (const Marks::Entry& entry : marks.bricks()) {
        const glm::ivec3 first = grid.brickAt(entry.first) * kMarkBrick;
        forEachVoxel({glm::ivec3(0), glm::ivec3(kMarkBrick)}, [&](glm::ivec3 t, std::size_t i) {
            const MarkTexel texel = entry.second->at(i);
            const glm::ivec3 voxel = (first + t) / grid.perVoxel;
            const double inside = std::clamp((texel.coverage / 255.0 - 0.5) * kMarkRamp + 0.5, 0.0, 1.0);
            if (inside > 0 && glm::all(glm::lessThan(voxel, n))) {
                const std::size_t at =
                    (std::size_t(voxel.z) * std::size_t(n.y) + std::size_t(voxel.y)) * std::size_t(n.x) +
                    std::size_t(voxel.x);
                const double opacity = inside * texel.opacity;
                sums[at] += opacity * glm::dvec4(texel.red, texel.green, texel.blue, 1);
            }
        });
    }
    for (const auto& [at, sum] : sums) {
        const glm::dvec3 mean = glm::dvec3(sum) / std::max(sum.w, 1e-9);
        colours[at] = {std::uint8_t(std::lround(mean.x)), std::uint8_t(std::lround(mean.y)),
                       std::uint8_t(std::lround(mean.z)), std::uint8_t(std::lround(sum.w / perVoxel))};
    }
    return colours;
}

std::vector<std::uint32_t> changedBricks(const Marks& before, const Marks& now) {
    return changedPlaces(before.bricks_, now.bricks_);
}

Box3 changedBetween(const Marks& before, const Marks& now) {
    const MarkGrid& grid = now.isEmpty() ? before.grid() : now.grid();
    Box3 all;
    for (const std::uint32_t place : changedBricks(before, now)) {
        const glm::ivec3 texel = grid.brickAt(place) * kMarkBrick;
        // A texel more on either side, where what lies between two is interpolated.
        const Box3 box{(texel - 1) / grid.perVoxel - 1, (texel + kMarkBrick + 1) / grid.perVoxel + 2};
        all = all.isEmpty() ? box : unite(all, box);
    }
    return all.isEmpty() ? all : intersect(all, {glm::ivec3(0), grid.dims});
}

} // namespace vs::field
