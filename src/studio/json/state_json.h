// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document_state.h"
#include "studio/json/state_file.h"

namespace vs::studio {

// The state of a document as it stands in files; its log is the session's business.

// Adds the large things to the file, and gives its table of contents.
nlohmann::ordered_json stored(StateWriter& file, const DocumentState& state);
// For a volume of that size. Throws SessionError naming file and member.
DocumentState readState(StateReader& file, glm::ivec3 dims);

} // namespace vs::studio
