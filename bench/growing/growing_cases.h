// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vs {

// A region to grow: what lies within `range` around the seeds.
struct GrowingCase {
    std::string name;
    volume::Volume volume;
    std::vector<glm::ivec3> seeds;
    Range range;
    std::optional<Range> wider; // a range that reaches that region and some more
};

// The brain of Debian's example head ch2better.nii.gz, or nothing where there is no such file.
std::optional<GrowingCase> brainCase(const std::string& path);

// All air around the body phantom of side^3 voxels (int16), from a corner.
GrowingCase airCase(int side);

// A compact region of about so many voxels, from its middle: |x|^4 + |y|^4 + |z|^4 < r^4 in a cube that just
// holds it, as uint8. One voxel in a hundred inside, here and there, belongs to the wider range only when
// `isSpeckled`.
GrowingCase compactCase(std::uint64_t voxels, bool isSpeckled);

// A line one voxel wide that runs to and fro through a cube, from one end.
GrowingCase thinCase(int voxels);

} // namespace vs
