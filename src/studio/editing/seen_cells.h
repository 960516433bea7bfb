// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace vs::studio {

class Display;
struct Contents;

// The middles (voxel space) of the macrocells that hold values of the range that the view shows and for whose
// number (x fastest) a condition holds.
std::vector<glm::dvec3> seenCells(const Contents& contents, const Display& display,
                                  const std::function<bool(std::size_t)>& isThere);
// The macrocells in which something of a pasted part can be seen, by the ranges of its macrocells.
std::vector<glm::dvec3> seenCellsOfPart(const Contents& contents, const Display& display,
                                        const std::vector<glm::vec2>& ranges);

// The middle (voxel space) of the macrocell with that number.
glm::dvec3 middleOfCell(std::size_t n, glm::ivec3 cellDims);
// The voxels around macrocells.
Box3 boxAround(const std::vector<glm::dvec3>& cells, const Contents& contents);
// The middle (voxel space) of a box of voxels; of an empty one, the grid's.
glm::dvec3 middleOf(const Box3& voxels, const Contents& contents);

} // namespace vs::studio
