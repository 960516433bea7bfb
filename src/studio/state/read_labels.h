// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/segmenting.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::studio {

// Where the voxels of a label map may lie: where those of the scene do, or those of the level that segments
// grow at, where that is a finer one.
struct LabelGrids {
    volume::GridGeometry scene;
    std::optional<volume::GridGeometry> finest = {};
};

// Reads the label map that an operation names and puts it in: of a store the finest level that lies on one of
// the grids, which is not held as a whole. Notices are appended. Throws ReadError, and Error when the
// operation has the checksum of another map. A map that was read whole and one that was read in bricks have
// checksums of two kinds; the latter cannot be told from another by one of the first kind, and is let in.
void readLabels(LoadLabels& labels, const LabelGrids& grids, std::vector<std::string>& notices);

} // namespace vs::studio
