// SPDX-License-Identifier: Apache-2.0
#include "mesh/vtk_mesh.h"

#include "base/progress.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cstring>

namespace vs::mesh {

namespace {

struct Watched {
    const Progress& progress;
    bool isGivenUp = false;
};

void hear(vtkObject* caller, unsigned long, void* data, void*) {
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    auto& watched = *static_cast<Watched*>(data);
    watched.isGivenUp = watched.isGivenUp || !watched.progress(filter->GetProgress());
    filter->SetAbortExecute(watched.isGivenUp ? 1 : 0);
}

} // namespace

QuietVtk::QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
QuietVtk::~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }

vtkSmartPointer<vtkPolyData> toVtk(const Mesh& mesh) {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(vtkIdType(mesh.points.size()));
    if (!mesh.points.empty()) {
        std::memcpy(coordinates->GetPointer(0), mesh.points.data(), mesh.points.size() * sizeof(glm::vec3));
    }
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(vtkIdType(mesh.triangles.size()), vtkIdType(3 * mesh.triangles.size()));
    for (const glm::uvec3 t : mesh.triangles) {
        triangles->InsertNextCell({vtkIdType(t.x), vtkIdType(t.y), vtkIdType(t.z)});
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(triangles);
    return data;
}

Mesh fromVtk(vtkPolyData& data) {
    Mesh mesh;
    mesh.points.resize(std::size_t(data.GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        glm::dvec3 point;
        data.GetPoint(vtkIdType(i), &point.x);
        mesh.points[i] = glm::vec3(point);
    }
    vtkCellArray* cells = data.GetPolys();
    mesh.triangles.reserve(std::size_t(cells->GetNumberOfCells()));
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    for (cells->InitTraversal(); cells->GetNextCell(count, corners) != 0;) {
        if (count == 3) {
            mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
        }
    }
    return mesh;
}

void run(vtkAlgorithm& filter, const Progress& progress) {
    const QuietVtk quiet;
    Watched watched{progress};
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(hear);
    command->SetClientData(&watched);
    if (progress) {
        filter.AddObserver(vtkCommand::ProgressEvent, command);
    }
    filter.Update();
    filter.RemoveObserver(command);
    if (watched.isGivenUp) {
        throw GivenUp("the export was given up");
    }
}

} // namespace vs::mesh
