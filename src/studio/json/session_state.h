// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document_state.h"
#include "studio/json/session.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vs::studio {

// Sessions with state: beside "head.json" lies "head.json.state" with all that the document held
// (DocumentState), so that it opens without doing everything again, and shows on any device what was saved.
// The session names the state by its checksum, and the state the operations that it comes from; where they do
// not fit each other, somebody has changed the session, and it is replayed.

// Where the state of a session lies.
std::filesystem::path statePath(const std::filesystem::path& session);

// Saves a document with its state; `source` as for sessionOf(). Whenever the program is killed, the session
// that was there before or the new one is there, with its state. If the state alone cannot be written, the
// session is saved without it, and a notice says so. Throws WriteError.
void saveDocument(const std::filesystem::path& path, const Document& document, const Session& source,
                  std::vector<std::string>& notices);

// The state that lies beside a session, for its volume. Nothing if there is none, or, with a notice, if it
// does not fit: the session is to be replayed then. `cutsFinest`: tools will cut a level that is finer than
// the volume (sculpt::FineSculpture), of which states say nothing; then one with cuts does not fit.
std::optional<DocumentState> loadState(const std::filesystem::path& path, const Session& session,
                                       const volume::Volume& volume, std::vector<std::string>& notices,
                                       bool cutsFinest = false);

} // namespace vs::studio
