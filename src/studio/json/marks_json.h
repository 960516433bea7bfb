// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "studio/json/state_file.h"

namespace vs::studio {

// Marks in the state of a session: a list of whole numbers (how they lie in voxels, and for each brick its
// place and where its block lies in the file). Steps of undo share marks, and marks share bricks: each is
// written once. Private to the state of sessions.
nlohmann::ordered_json stored(StateWriter& file, const field::SharedMarks& marks);
// Throws SessionError naming file and member.
field::SharedMarks readMarks(StateReader& file, const JsonReader& from, glm::ivec3 dims);

} // namespace vs::studio
