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

// Reads a text as JSON, as readJsonFile() does; `where` is how it is called in messages.
nlohmann::ordered_json parseJson(const std::string& text, const std::string& where, const std::string& wanted,
                                 const std::string& documentation);

} // namespace vs
