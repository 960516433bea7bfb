// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace vs {

// Reads a whole file as JSON. Throws SessionError naming the file; `wanted` says in the message what would be
// right: "a session file", "doc/session.md".
nlohmann::ordered_json readJsonFile(const std::filesystem::path& path, const std::string& wanted,
                                    const std::string& documentation);

} // namespace vs
