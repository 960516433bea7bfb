// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_growth.h"
#include "segment/growth/growth_undo.h"

namespace vs::studio {

// Undoes one change of a document's segments: of those of the level that is worked on, or, where they grow at
// a finer one, of those.
struct RegionUndo {
    segment::GrowthUndo scene;
    segment::FineUndo finest = {};
};

} // namespace vs::studio
