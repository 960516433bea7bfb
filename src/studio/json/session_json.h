// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/json_reader.h"
#include "studio/json/session.h"

namespace vs::studio {

// What session files and the journal have in common: which volume. Private to the two.

inline constexpr int kJournalVersion = 1;

// The member "volume"; `path` is how the volume's file is named there.
nlohmann::ordered_json volumeToJson(const Session& session, const std::filesystem::path& path);
void readVolume(const JsonReader& reader, Session& session);
sculpt::Precision readPrecision(const JsonReader& reader);

} // namespace vs::studio
