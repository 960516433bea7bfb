// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/colours/transfer_function.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <vector>

namespace vs::render {

// Transfer functions as they stand in files (doc/transfer_functions.md). What is written comes back equal.
nlohmann::ordered_json toJson(const TransferFunction& function);
// Reads a transfer function. Throws SessionError saying which member is wrong and what would be right;
// `where` begins the message.
TransferFunction transferFunctionFromJson(const nlohmann::ordered_json& json, const std::string& where);

// Reads a transfer function from a file. Throws SessionError naming file and place.
TransferFunction loadTransferFunction(const std::filesystem::path& path);
// Writes a transfer function into a file. Throws WriteError naming the file.
void saveTransferFunction(const std::filesystem::path& path, const TransferFunction& function);

// The presets of data/transfer_functions, by file name without its extension, in alphabetical order.
std::vector<std::string> presetNames();
// The preset of a name; nothing if there is none.
std::optional<TransferFunction> findPreset(const std::string& name);

// The function that a preset's name or else a file's stands for. Throws UsageError listing the presets if it
// is neither, SessionError if the file's content is wrong.
TransferFunction transferFunctionFromArgument(const std::string& text);

} // namespace vs::render
