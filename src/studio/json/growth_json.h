// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth_snapshot.h"
#include "segment/growth/growth_undo.h"
#include "studio/json/state_file.h"

namespace vs::studio {

// What growth holds, and what undoes its calls, as the state of a session keeps them. Private to that.
nlohmann::ordered_json stored(StateWriter& file, const segment::GrowthSnapshot& growth);
nlohmann::ordered_json stored(StateWriter& file, const segment::GrowthUndo& undo);

// For a volume of that size. What is fenced names some sculpture.
segment::GrowthSnapshot readGrowth(StateReader& file, const JsonReader& from, glm::ivec3 dims);
segment::GrowthUndo readGrowthUndo(StateReader& file, const JsonReader& from, glm::ivec3 dims);

} // namespace vs::studio
