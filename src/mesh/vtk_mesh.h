// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkAlgorithm;

// Meshes as VTK has them. Internal to this folder.
namespace vs::mesh {

// VTK says nothing on the terminal as long as this lives: what failed is seen by what is missing.
class QuietVtk {
public:
    QuietVtk();
    ~QuietVtk();
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    int before_;
};

// Name, colour and opacity are lost.
vtkSmartPointer<vtkPolyData> toVtk(const Mesh& mesh);
// Only triangles.
Mesh fromVtk(vtkPolyData& data);

// Runs a filter. Throws GivenUp when `progress` says so.
void run(vtkAlgorithm& filter, const Progress& progress);

} // namespace vs::mesh
