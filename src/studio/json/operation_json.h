// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace vs::studio {

// Operations as they stand in session files (doc/session.md).
nlohmann::ordered_json toJson(const Operation& operation);

// Throws SessionError saying which member is wrong and what would be right; `where` begins the message
// ("head.json: operation 3").
Operation operationFromJson(const nlohmann::ordered_json& json, const std::string& where);

// Whether one of the operation's fields that name segments (Rule::isReference) names this one.
bool speaksOf(const Operation& operation, std::string_view segment);

} // namespace vs::studio
