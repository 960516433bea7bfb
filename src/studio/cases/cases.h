// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/embedded_text.h"
#include "studio/cases/case_index.h"
#include "studio/json/session.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vs::studio {

// The files of examples/experiments, in alphabetical order (generated at build).
std::span<const EmbeddedText> embeddedCases();

// What the program has cases of. Read once.
const CaseIndex& caseIndex();

// The session of a case, its volume as the session names it. Throws SessionError for a case that there is
// not.
Session sessionOf(const Case& which);

// What the index says of the scan of a session; null for a volume that is made.
const CaseScan* scanOf(const Session& session);

// Looks for a file where a session says that it lies, if that is an absolute path, and then by its name in
// each folder.
std::optional<std::filesystem::path> findFile(const std::filesystem::path& named,
                                              std::span<const std::filesystem::path> folders);

} // namespace vs::studio
