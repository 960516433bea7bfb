// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/fill/fill.h"
#include "mesh/mesh.h"
#include "volume/grid/geometry.h"

#include <cstdint>

namespace vs::mesh {

// The surface of one material alone, where it is half filled, closed; empty where there is none of it.
// Another material beside it counts as air.
Mesh fillSurface(const field::Fill& fill, std::uint8_t material, const volume::GridGeometry& geometry);

} // namespace vs::mesh
