// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/kept_json.h"

#include <vector>

namespace vs::studio {

// Steps of undo and redo as the state of a session keeps them. Private to that.
Json stored(StateWriter& file, const std::vector<SavedEdit>& edits);
// For a volume of that size; those that are `areDone` can be undone, the others done again.
std::vector<SavedEdit> readEdits(StateReader& file, const JsonReader& from, glm::ivec3 dims, bool areDone);
// That undo fits what there is. Throws SessionError.
void checkUndo(const JsonReader& from, const DocumentState& state);

} // namespace vs::studio
