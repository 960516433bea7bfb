// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/value_json.h"
#include "render/colours/transfer_function.h"

#include <string>

namespace vs {

// A transfer function in a session file: a preset's name, or a whole function.
Json schemaOf(Type<render::TransferFunction>, const Rule& rule, Json& definitions);

} // namespace vs

namespace vs::render {

// What the description of transfer functions says of their files (render/colours/transfer_function.h), for
// doc/transfer_functions.md.

// The schema of such files (doc/transfer_function.schema.json), JSON Schema draft 2020-12.
Json functionSchema();

// A table in Markdown: what each member may be.
std::string functionTable();

} // namespace vs::render
