// SPDX-License-Identifier: Apache-2.0
#include "mesh/contour.h"

#include "base/parallel.h"
#include "mesh/vtk_mesh.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vs::mesh {

namespace {

constexpr double kNearest = 0.01; // to a voxel's centre, as a share of the way to the next
constexpr int kPointsAtOnce = 1 << 14;

// The surface of a set in its box, which may lie outside the grid. Points half way between voxels, in voxels
// from the box's first.
Mesh halfWay(const segment::VoxelSet& set) {
    const QuietVtk quiet;
    vtkNew<vtkUnsignedCharArray> values;
    // The filter only looks at them.
    values->SetArray(const_cast<unsigned char*>(set.inside.data()), vtkIdType(set.inside.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(set.box.size().x, set.box.size().y, set.box.size().z);
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, 0.5);
    edges->ComputeNormalsOff();
    edges->ComputeGradientsOff();
    edges->ComputeScalarsOff();
    edges->Update();
    return fromVtk(*edges->GetOutput());
}

// Where a point half way between two voxels belongs, in voxel space.
glm::dvec3 movedToCrossing(glm::dvec3 point, const segment::VoxelSet& set, const Box3& grid,
                           const Crossing& crossing) {
    const glm::ivec3 below(glm::floor(point));
    const glm::ivec3 above(glm::ceil(point));
    const bool isInsideBelow = set.contains(below);
    const glm::ivec3 inside = isInsideBelow ? below : above;
    const glm::ivec3 outside = isInsideBelow ? above : below;
    const bool isAtBorder =
        glm::any(glm::lessThan(outside, grid.lo)) || glm::any(glm::greaterThanEqual(outside, grid.hi));
    const double share = isAtBorder ? 0.5 : std::clamp(crossing(inside, outside), kNearest, 1 - kNearest);
    return glm::mix(glm::dvec3(inside), glm::dvec3(outside), share);
}

// A point half way between two voxels: twice its place, which is a whole number.
struct HalfWay {
    glm::ivec3 twice{0};
    bool operator==(const HalfWay&) const = default;
};
struct HashOfHalfWay {
    std::size_t operator()(const HalfWay& at) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            hash = (hash ^ std::uint32_t(at.twice[axis])) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32U;
        }
        return std::size_t(hash);
    }
};

// Joins the meshes of pieces at the points that they have in common: those on the pieces' faces.
class Joined {
public:
    // `piece` has points half way between voxels of a box, whose faces are shared with other pieces. Returns
    // the number of points that all had before.
    std::size_t add(Mesh piece, const Box3& box, bool isOnly) {
        const std::size_t before = mesh_.points.size();
        if (isOnly) {
            mesh_ = std::move(piece);
            for (glm::vec3& point : mesh_.points) {
                point = 2.0F * (point + glm::vec3(box.lo));
            }
            return before;
        }
        std::vector<std::uint32_t> numbers;
        numbers.reserve(piece.points.size());
        const glm::ivec3 lo = 2 * box.lo;
        const glm::ivec3 hi = 2 * (box.hi - 1);
        for (const glm::vec3& point : piece.points) {
            const glm::ivec3 twice = lo + glm::ivec3(glm::round(2.0F * point));
            const auto next = std::uint32_t(mesh_.points.size());
            std::uint32_t number = next;
            if (glm::any(glm::equal(twice, lo)) || glm::any(glm::equal(twice, hi))) {
                number = shared_.try_emplace({twice}, next).first->second;
            }
            if (number == next) {
                mesh_.points.emplace_back(twice);
            }
            numbers.push_back(number);
        }
        for (const glm::uvec3& t : piece.triangles) {
            mesh_.triangles.emplace_back(numbers[t.x], numbers[t.y], numbers[t.z]);
        }
        return before;
    }
    Mesh& mesh() { return mesh_; }

private:
    Mesh mesh_; // with twice the places of points that were not moved yet
    std::unordered_map<HalfWay, std::uint32_t, HashOfHalfWay> shared_;
};

// Moves points from `first` on from twice their places in voxel space to the surface in the patient.
void move(Mesh& mesh, std::size_t first, const segment::VoxelSet& set, const volume::GridGeometry& geometry,
          const Crossing& crossing) {
    const int count = int(mesh.points.size() - first);
    inParallel(divideUp(count, kPointsAtOnce), threadsForMemory(), [&](int part) {
        for (int i = part * kPointsAtOnce; i < std::min(count, (part + 1) * kPointsAtOnce); ++i) {
            glm::vec3& point = mesh.points[first + std::size_t(i)];
            const glm::dvec3 voxel = movedToCrossing(glm::dvec3(point) / 2.0, set, geometry.box(), crossing);
            point = glm::vec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
        }
    });
}

void turnOutward(Mesh& mesh, const volume::GridGeometry& geometry) {
    if (glm::determinant(glm::dmat3(geometry.worldFromVoxel)) < 0) {
        for (glm::uvec3& triangle : mesh.triangles) {
            std::swap(triangle.y, triangle.z);
        }
    }
}

} // namespace

Mesh contour(const segment::VoxelSet& set, const volume::GridGeometry& geometry, const Crossing& crossing) {
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    const Box3 padded = grow(tight, 1);
    const glm::ivec3 size = padded.size();
    const int side = std::max({size.x, size.y, size.z}); // one piece
    return contour(
        tight, geometry,
        [&](const Box3& box) {
            return Piece{set.within(box), crossing};
        },
        side);
}

Mesh contour(const Box3& box, const volume::GridGeometry& geometry, const PieceOf& pieceOf, int side,
             const Progress& progress) {
    Joined joined;
    const Box3 padded = grow(box, 1);
    const glm::ivec3 pieces = divideUp(padded.size() - 1, side - 1);
    const auto count = double(pieces.x) * pieces.y * pieces.z;
    forEachVoxel(Box3{glm::ivec3(0), pieces}, [&](glm::ivec3 place, std::size_t n) {
        report(progress, double(n) / count);
        // Neighbours have a layer of voxels in common: cells lie between voxels.
        const glm::ivec3 lo = padded.lo + place * (side - 1);
        const Box3 own{lo, glm::min(lo + side, padded.hi)};
        const Piece piece = pieceOf(own);
        if (!piece.set.box.isEmpty()) {
            const std::size_t first = joined.add(halfWay(piece.set), own, pieces == glm::ivec3(1));
            move(joined.mesh(), first, piece.set, geometry, piece.crossing);
        }
    });
    Mesh mesh = std::move(joined.mesh());
    turnOutward(mesh, geometry);
    return mesh;
}

} // namespace vs::mesh
