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

namespace vs::mesh {

namespace {

constexpr double kNearest = 0.01; // to a voxel's centre, as a share of the way to the next
constexpr int kPointsAtOnce = 1 << 14;

// The set in its tight box and one voxel around, which may lie outside the grid. Points half way between
// voxels, in voxels from the box's first.
Mesh halfWay(const segment::VoxelSet& padded) {
    const QuietVtk quiet;
    vtkNew<vtkUnsignedCharArray> values;
    // The filter only looks at them.
    values->SetArray(const_cast<unsigned char*>(padded.inside.data()), vtkIdType(padded.inside.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(padded.box.size().x, padded.box.size().y, padded.box.size().z);
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

} // namespace

Mesh contour(const segment::VoxelSet& set, const volume::GridGeometry& geometry, const Crossing& crossing) {
    const Box3 tight = set.tightBox();
    if (tight.isEmpty()) {
        return {};
    }
    const segment::VoxelSet padded = set.within(grow(tight, 1));
    Mesh mesh = halfWay(padded);
    const int count = int(mesh.points.size());
    inParallel(divideUp(count, kPointsAtOnce), threadsForMemory(), [&](int part) {
        for (int i = part * kPointsAtOnce; i < std::min(count, (part + 1) * kPointsAtOnce); ++i) {
            glm::vec3& point = mesh.points[std::size_t(i)];
            const glm::dvec3 voxel = movedToCrossing(glm::dvec3(point) + glm::dvec3(padded.box.lo), padded,
                                                     geometry.box(), crossing);
            point = glm::vec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
        }
    });
    if (glm::determinant(glm::dmat3(geometry.worldFromVoxel)) < 0) {
        for (glm::uvec3& triangle : mesh.triangles) {
            std::swap(triangle.y, triangle.z);
        }
    }
    return mesh;
}

} // namespace vs::mesh
