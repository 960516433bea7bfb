// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/sweep.h"

#include <algorithm>

namespace vs::sculpt {

namespace {

bool staysInItsPlane(const PathPiece& piece) {
    const glm::dvec3 normal = glm::cross(piece.from.x, piece.from.y);
    const auto isAcross = [&](const glm::dvec3& v) { return std::abs(glm::dot(v, normal)) < 1e-9; };
    return isAcross(piece.to.origin - piece.from.origin) && isAcross(piece.to.x) && isAcross(piece.to.y);
}

// Whether any of the mask may pass between the grid's corners: it stays within the hull of its own.
bool mayReach(const MaskRaster& mask, const PathPiece& piece, const SweepGrid& grid) {
    glm::dvec3 lo(1e30);
    glm::dvec3 hi(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec2 size(mask.size - 1);
        const glm::dvec2 element =
            mask.origin + mask.pitch * size * glm::dvec2(corner & 1, (corner >> 1) & 1);
        const glm::dvec3 p = grid.voxelFromSteps * ((corner & 4) != 0 ? piece.to : piece.from).place(element);
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    return glm::all(glm::lessThanEqual(lo, glm::dvec3(grid.hi))) &&
           glm::all(glm::greaterThanEqual(hi, glm::dvec3(grid.lo)));
}

SweepGrid gridOf(const glm::ivec3& dims, const Footprint& footprint, const glm::dvec3& voxelFromSteps) {
    const glm::vec3 sigma(footprint.sigmaVoxels);
    const glm::vec3 reach(footprint.reachVoxels() + 1);
    SweepGrid grid;
    grid.voxelFromSteps = voxelFromSteps;
    grid.density = {SweptPatches::densityFor(sigma.x), SweptPatches::densityFor(sigma.y),
                    SweptPatches::densityFor(sigma.z)};
    grid.lo = -reach;
    grid.hi = glm::vec3(dims) + reach;
    return grid;
}

} // namespace

glm::dvec3 voxelFromSteps(const glm::dvec3& spacing) {
    return std::min({spacing.x, spacing.y, spacing.z}) / spacing;
}

Footprint sweepFootprint(int radius, const glm::dvec3& spacing) {
    FootprintShape shape;
    shape.radius = radius;
    shape.isSmoothWhereCoarse = true;
    return fitFootprint(shape, spacing);
}

SweptPatches sweepPiece(const MaskRaster& mask, const PathPiece& piece, const SweepGrid& grid) {
    // Depth 0 is the piece's start, 1 its end. Elements that move backwards, on the inner side of a turn,
    // count nothing.
    SweptPatches out(0, 1, 1);
    if (staysInItsPlane(piece) || !mayReach(mask, piece, grid)) {
        return out;
    }
    out.setDensity(grid.density);
    out.clipTo(grid.lo, grid.hi);
    for (int j = 0; j < mask.size.y; ++j) {
        for (int i = 0; i < mask.size.x; ++i) {
            const glm::dvec2 element = mask.origin + mask.pitch * glm::dvec2(i, j);
            const glm::dvec3 start = grid.voxelFromSteps * piece.from.place(element);
            const glm::dvec3 end = grid.voxelFromSteps * piece.to.place(element);
            out.addCorner(glm::vec3(start), glm::vec3(end - start), mask.at(i, j));
        }
    }
    const auto row = std::uint32_t(mask.size.x);
    for (int j = 0; j + 1 < mask.size.y; ++j) {
        for (int i = 0; i + 1 < mask.size.x; ++i) {
            const auto corner = std::uint32_t(j) * row + std::uint32_t(i);
            out.addCell({corner, corner + 1, corner + row, corner + row + 1});
        }
    }
    return out;
}

Box3 sweepMask(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask,
               std::span<const PathPiece> path, glm::ivec3 dims, const Footprint& footprint,
               const glm::dvec3& voxelFromSteps) {
    const SweepGrid grid = gridOf(dims, footprint, voxelFromSteps);
    Box3 box;
    for (const PathPiece& piece : path) {
        box = unite(box, sweepPiece(mask, piece, grid).pointBox());
    }
    radiator.begin(box, dims, footprint);
    for (const PathPiece& piece : path) {
        generator.generate(sweepPiece(mask, piece, grid), [&](const gl::Buffer& points, std::size_t count) {
            radiator.deposit(points, count);
        });
    }
    return radiator.finish();
}

} // namespace vs::sculpt
