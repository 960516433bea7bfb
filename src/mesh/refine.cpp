// SPDX-License-Identifier: Apache-2.0
#include "mesh/refine.h"

#include "mesh/close_holes.h"
#include "mesh/vtk_mesh.h"

#include <vtkNew.h>
#include <vtkQuadricDecimation.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>

namespace vs::mesh {

namespace {

// Waves shorter than about twenty triangles' edges go.
constexpr double kPassBand = 0.05;

// The same triangles' mesh with other points.
vtkSmartPointer<vtkPolyData> smoothed(vtkPolyData& data, int passes, const Progress& progress) {
    vtkNew<vtkWindowedSincPolyDataFilter> filter;
    filter->SetInputData(&data);
    filter->SetNumberOfIterations(passes);
    filter->SetPassBand(kPassBand);
    filter->NormalizeCoordinatesOn();
    filter->NonManifoldSmoothingOn(); // where parts touch along an edge, that edge moves along
    filter->FeatureEdgeSmoothingOff();
    filter->BoundarySmoothingOff();
    run(*filter, progress);
    return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> decimated(vtkPolyData& data, double share, const Progress& progress) {
    vtkNew<vtkQuadricDecimation> filter;
    filter->SetInputData(&data);
    filter->SetTargetReduction(1 - share);
    filter->VolumePreservationOn();
    run(*filter, progress);
    return filter->GetOutput();
}

} // namespace

Mesh refined(Mesh mesh, const Refinement& refinement, const Progress& progress) {
    const double count = double(std::max<std::size_t>(mesh.triangles.size(), 1));
    const double most = refinement.mostTriangles ? double(*refinement.mostTriangles) : count;
    const double share = std::clamp(std::min(refinement.share, most / count), 0.0, 1.0);
    if (mesh.triangles.empty() || (refinement.smoothing == 0 && share == 1)) {
        return mesh;
    }
    const bool isClosed = topologyOf(mesh).isClosed();
    vtkSmartPointer<vtkPolyData> data = toVtk(mesh);
    if (refinement.smoothing > 0) {
        data = smoothed(*data, refinement.smoothing, partOf(progress, 0, share < 1 ? 0.3 : 1));
    }
    if (share < 1) {
        data = decimated(*data, share, partOf(progress, refinement.smoothing > 0 ? 0.3 : 0, 1));
    }
    Mesh result = fromVtk(*data);
    if (share < 1 && isClosed) {
        closeHoles(result);
    }
    result.name = mesh.name;
    result.colour = mesh.colour;
    result.opacity = mesh.opacity;
    return result;
}

} // namespace vs::mesh
