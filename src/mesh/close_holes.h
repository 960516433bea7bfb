// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.h"

namespace vs::mesh {

// Closes the small holes that decimation leaves of a closed surface, where it has dropped one of two
// triangles that had come to lie on each other: each loop of open edges gets triangles around its first
// point, and pairs of triangles with the same corners that face each other go.
void closeHoles(Mesh& mesh);

} // namespace vs::mesh
