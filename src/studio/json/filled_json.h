// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/state_file.h"
#include "studio/state/filled.h"

namespace vs::studio {

// What is filled, in the state of a session: the list of materials, and a list of whole numbers (for each
// brick its place and where its block lies in the file). Steps of undo share fills, and these share bricks:
// each is there once.
nlohmann::ordered_json stored(StateWriter& file, const Filled& filled);
// Throws as StateReader does, and if something of it is not what a scan of these dimensions can have.
Filled readFilled(StateReader& file, const JsonReader& from, glm::ivec3 dims);

} // namespace vs::studio
