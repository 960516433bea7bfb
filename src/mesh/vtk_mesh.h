// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkAlgorithm;

// Meshes as VTK has them. Internal to this folder.
namespace vs::mesh {

// While it lives, VTK says nothing on the terminal: what failed is seen by what is missing.
class QuietVtk {
public:
    QuietVtk();
    ~QuietVtk();
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    int before_;
};

// A mesh's points and triangles for VTK; its name, colour and opacity are left out.
vtkSmartPointer<vtkPolyData> toVtk(const Mesh& mesh);
// A mesh of VTK's points and triangles; its other polygons are left out.
Mesh fromVtk(vtkPolyData& data);

// Runs a filter. Throws GivenUp when `progress` says so.
void run(vtkAlgorithm& filter, const Progress& progress);

} // namespace vs::mesh
