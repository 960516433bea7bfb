// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/segment_list.h"
#include "studio/operations/view.h"
#include "studio/state/pasted_parts.h"

#include <vector>

namespace vs::studio {

// Where the parts of a picture are drawn: where they were put or, while they are held in the hand, where the
// view says, and moved apart by the view's spread.

// One for each place of the view, hidden or not.
std::vector<render::Placement> shownPlaces(const View& view, const PastedState& pasted,
                                           const volume::GridGeometry& geometry);
// The place of a segment that is pulled out.
render::Placement shownPlace(const View& view, const SegmentInfo& segment,
                             const volume::GridGeometry& geometry);

} // namespace vs::studio
