// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/sweep.h"

#include "base/error.h"
#include "base/progress.h"

#include <algorithm>
#include <utility>

namespace vs::sculpt {

namespace {

bool staysInItsPlane(const PathPiece& piece) {
    const glm::dvec3 normal = glm::cross(piece.from.x, piece.from.y);
    const auto isAcross = [&](const glm::dvec3& v) { return std::abs(glm::dot(v, normal)) < 1e-9; };
    return isAcross(piece.to.origin - piece.from.origin) && isAcross(piece.to.x) && isAcross(piece.to.y);
}

// Whether any of a window may pass between the grid's corners: it stays within the hull of its own.
bool mayReach(const MaskWindow& window, const PathPiece& piece, const SweepGrid& grid) {
    glm::dvec3 lo(1e300);
    glm::dvec3 hi(-1e300);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec2 element((corner & 1) != 0 ? window.hi.x : window.lo.x,
                                 (corner & 2) != 0 ? window.hi.y : window.lo.y);
        const glm::dvec3 p = grid.voxelFromSteps * ((corner & 4) != 0 ? piece.to : piece.from).place(element);
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    return glm::all(glm::lessThanEqual(lo, glm::dvec3(grid.hi))) &&
           glm::all(glm::greaterThanEqual(hi, glm::dvec3(grid.lo)));
}

// Finds what of a mask's plane may come into the grid, halving what may until it is small beside the grid.
class WindowFinder {
public:
    explicit WindowFinder(const SweepGrid& grid) : grid_(grid) {
        const glm::dvec3 steps = glm::dvec3(grid.hi - grid.lo) / grid.voxelFromSteps;
        leaf_ = std::max(glm::length(steps) / 16, 1e-3);
    }

    void add(const MaskWindow& part, const PathPiece& piece, int level = 0) {
        const bool isKnown = glm::all(glm::lessThanEqual(found_.lo, part.lo)) &&
                             glm::all(glm::greaterThanEqual(found_.hi, part.hi));
        if (isKnown || !mayReach(part, piece, grid_)) {
            return;
        }
        const glm::dvec2 size = part.hi - part.lo;
        if (std::max(size.x, size.y) <= leaf_ || level == kMostHalvings) {
            found_.include(part);
            return;
        }
        const int axis = size.x >= size.y ? 0 : 1;
        const double middle = 0.5 * (part.lo[axis] + part.hi[axis]);
        MaskWindow half = part;
        half.hi[axis] = middle;
        add(half, piece, level + 1);
        half = part;
        half.lo[axis] = middle;
        add(half, piece, level + 1);
    }

    [[nodiscard]] const MaskWindow& found() const { return found_; }

private:
    static constexpr int kMostHalvings = 48;

    const SweepGrid& grid_;
    double leaf_ = 1;
    MaskWindow found_;
};

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

PathRegion SweepGrid::region(const MaskWindow& mask) const {
    const double reach = mask.isEmpty() ? 0 : glm::length(glm::max(glm::abs(mask.lo), glm::abs(mask.hi)));
    return {glm::dvec3(lo) / voxelFromSteps, glm::dvec3(hi) / voxelFromSteps, reach};
}

SweepGrid sweepGrid(const glm::ivec3& dims, const Footprint& footprint, const glm::dvec3& voxelFromSteps) {
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

MaskWindow windowInto(const SweepGrid& grid, const MaskWindow& window, const PathPiece& piece) {
    WindowFinder finder(grid);
    finder.add(window, piece);
    return finder.found();
}

Outline outlineInto(const SweepGrid& grid, Outline outline, std::span<const PathPiece> path, double pitch,
                    const MaskFilter& filter) {
    // What the mask reaches beyond its outline comes in too, and what its elements at the window's rim look
    // at.
    const double room = pitch * filterReach(filter);
    MaskWindow window = windowAround(outline);
    WindowFinder finder(grid);
    for (const PathPiece& piece : path) {
        finder.add({window.lo - room, window.hi + room}, piece);
    }
    return finder.found().isEmpty()
               ? Outline{}
               : clipToBox(std::move(outline), finder.found().lo - 2 * room, finder.found().hi + 2 * room);
}

MaskElements elementsInto(const SweepGrid& grid, const MaskRaster& mask, const PathPiece& piece) {
    const MaskWindow window = windowInto(grid, mask.window(), piece);
    if (window.isEmpty()) {
        return {};
    }
    const glm::dvec2 lo = glm::floor((window.lo - mask.origin) / mask.pitch);
    const glm::dvec2 hi = glm::ceil((window.hi - mask.origin) / mask.pitch) + 1.0;
    return {glm::max(glm::ivec2(lo), glm::ivec2(0)), glm::min(glm::ivec2(hi), mask.size)};
}

SweptPatches sweepPiece(const MaskRaster& mask, const PathPiece& piece, const SweepGrid& grid) {
    // Depth 0 is the piece's start, 1 its end. Elements that move backwards, on the inner side of a turn,
    // count nothing.
    SweptPatches out(0, 1, 1);
    if (staysInItsPlane(piece)) {
        return out;
    }
    const MaskElements elements = elementsInto(grid, mask, piece);
    out.setDensity(grid.density);
    out.clipTo(grid.lo, grid.hi);
    for (int j = elements.lo.y; j < elements.hi.y; ++j) {
        for (int i = elements.lo.x; i < elements.hi.x; ++i) {
            const glm::dvec2 element = mask.origin + mask.pitch * glm::dvec2(i, j);
            const glm::dvec3 start = grid.voxelFromSteps * piece.from.place(element);
            const glm::dvec3 end = grid.voxelFromSteps * piece.to.place(element);
            out.addCorner(glm::vec3(start), glm::vec3(end - start), mask.at(i, j));
        }
    }
    const glm::ivec2 size = glm::max(elements.hi - elements.lo, glm::ivec2(0));
    const auto row = std::uint32_t(size.x);
    for (int j = 0; j + 1 < size.y; ++j) {
        for (int i = 0; i + 1 < size.x; ++i) {
            const auto corner = std::uint32_t(j) * row + std::uint32_t(i);
            out.addCell({corner, corner + 1, corner + row, corner + row + 1});
        }
    }
    return out;
}

SweptWay wayInto(const SweepGrid& grid, glm::ivec3 dims, const MaskRaster& mask,
                 std::span<const PathPiece> path) {
    SweptWay way;
    // What is swept through a grid over and over says nothing more, and takes hours: solids that are made
    // pass each voxel a few times.
    const double voxels = double(dims.x) * dims.y * dims.z;
    const double most = std::max(4e6, 64 * voxels);
    double passes = 0; // of one element along one piece
    for (const PathPiece& piece : path) {
        const MaskElements elements = elementsInto(grid, mask, piece);
        passes += double(elements.hi.x - elements.lo.x) * double(elements.hi.y - elements.lo.y);
        if (passes > most) {
            throw Error(
                "the mask passes every voxel of the volume {:.0f} times; make its path shorter or the "
                "mask smaller",
                passes / voxels);
        }
        const Box3 points = sweepPiece(mask, piece, grid).pointBox();
        if (!points.isEmpty()) {
            way.pieces.push_back(piece);
            way.boxes.push_back(points);
            way.points = unite(way.points, points);
        }
        reportProgress(0.0);
    }
    return way;
}

Box3 sweepWay(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask, const SweptWay& way,
              const SweepGrid& grid, const Box3& within, const Footprint& footprint) {
    radiator.begin(way.points, within, footprint);
    const Box3 near = reachOf(within, footprint);
    for (std::size_t n = 0; n < way.pieces.size(); ++n) {
        reportProgress(double(n) / double(way.pieces.size()));
        if (intersect(way.boxes[n], near).isEmpty()) {
            continue;
        }
        generator.generateIn(
            near, sweepPiece(mask, way.pieces[n], grid),
            [&](const gl::Buffer& points, std::size_t count) { radiator.deposit(points, count); });
    }
    return radiator.finish();
}

Box3 sweepMask(Radiator& radiator, PointGenerator& generator, const MaskRaster& mask,
               std::span<const PathPiece> path, glm::ivec3 dims, const Footprint& footprint,
               const glm::dvec3& voxelFromSteps) {
    const SweepGrid grid = sweepGrid(dims, footprint, voxelFromSteps);
    return sweepWay(radiator, generator, mask, wayInto(grid, dims, mask, path), grid, {glm::ivec3(0), dims},
                    footprint);
}

} // namespace vs::sculpt
