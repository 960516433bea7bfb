// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Formats that this folder writes itself. Internal to it.
namespace vs::mesh {

// A text on the space and unit of files in LPS millimetres, for their headers; 3D Slicer looks for
// SPACE=LPS.
inline constexpr const char* kSpaceNote = "Volume Studio, millimetres, SPACE=LPS";

// Wavefront OBJ; `materials` is the name of its material file.
std::string objText(std::span<const Mesh> meshes, const std::string& materials);
// The text of the material file that objText() refers to.
std::string mtlText(std::span<const Mesh> meshes);

// The bytes of a binary glTF 2.0 file. Throws std::length_error when there are more than it holds (4 GiB).
std::vector<std::byte> glbBytes(std::span<const Mesh> meshes);

} // namespace vs::mesh
