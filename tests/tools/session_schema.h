// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace vs::studio {

// What the operations' descriptions say of session files (operations/description.h), for doc/session.md.

// The schema of session files (doc/session.schema.json), JSON Schema draft 2020-12.
nlohmann::ordered_json sessionSchema();

// Two tables in Markdown: what each operation is called, has and does; and what each member may be.
std::string operationTables();

} // namespace vs::studio
