// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <filesystem>
#include <span>

namespace vs::mesh {

// Whether a name ends in a format that meshes are written in: .stl .ply .obj .glb.
bool isMeshName(const std::filesystem::path& path);

// Writes meshes into one file, by its extension:
//   .stl  binary; all triangles together
//   .ply  binary; all triangles together, each point in its colour
//   .obj  an object each, with normals; colours in a .mtl file beside it, which is written first; where
//         points have colours of their own, these stand behind their places, as most programs read them
//   .glb  binary glTF 2.0; a node each, with normals and colour, of points too where they have one
// The first three are in LPS millimetres, and say so as 3D Slicer reads it ("SPACE=LPS"); glTF is, as its
// specification wants it, in metres with the patient's superior up (+Y), anterior to the front (+Z) and left
// to +X. Each file is whole or untouched. Throws WriteError naming the file, also when there is no triangle.
void writeMeshes(const std::filesystem::path& path, std::span<const Mesh> meshes);

} // namespace vs::mesh
