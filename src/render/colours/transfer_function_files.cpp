// SPDX-License-Identifier: Apache-2.0
#include "base/atomic_file.h"
#include "base/error.h"
#include "base/json_file.h"
#include "render/colours/embedded_presets.h"
#include "render/colours/transfer_function_json.h"

#include <algorithm>
#include <map>

namespace vs::render {

using Json = nlohmann::ordered_json;

TransferFunction loadTransferFunction(const std::filesystem::path& path) {
    return transferFunctionFromJson(readJsonFile(path, "a transfer function", "doc/transfer_functions.md"),
                                    path.string());
}

namespace {

// One member a line, and one point or shape: such files are read and edited by people too.
std::string textOf(const Json& json) {
    std::string text = "{";
    for (const auto& item : json.items()) {
        text += fmt::format("{}\n  {}: ", text.size() == 1 ? "" : ",", Json(item.key()).dump());
        if (item.value().is_array()) {
            std::string rows;
            for (const Json& row : item.value()) {
                rows += fmt::format("{}\n    {}", rows.empty() ? "" : ",", row.dump());
            }
            text += "[" + rows + "\n  ]";
        } else {
            text += item.value().dump();
        }
    }
    return text + "\n}\n";
}

} // namespace

void saveTransferFunction(const std::filesystem::path& path, const TransferFunction& function) {
    std::string text;
    try {
        text = textOf(toJson(function));
    } catch (const Json::exception&) {
        throw WriteError("{}: cannot be saved: name and description must be UTF-8 text", path.string());
    }
    writeFileAtomically(path, text);
}

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const EmbeddedText& preset : embeddedPresets()) {
        names.emplace_back(preset.name);
    }
    return names;
}

std::optional<TransferFunction> findPreset(const std::string& name) {
    static const auto presets = [] {
        std::map<std::string, TransferFunction> all;
        for (const EmbeddedText& preset : embeddedPresets()) {
            const std::string key(preset.name);
            all[key] = transferFunctionFromJson(Json::parse(preset.text), "preset " + key);
        }
        return all;
    }();
    const auto found = presets.find(name);
    return found == presets.end() ? std::nullopt : std::optional(found->second);
}

TransferFunction transferFunctionFromArgument(const std::string& text) {
    if (auto preset = findPreset(text)) {
        return *std::move(preset);
    }
    std::error_code ignored;
    if (!std::filesystem::exists(text, ignored)) {
        throw UsageError("transfer function '{}' is neither a file nor a preset; presets are {}", text,
                         fmt::join(presetNames(), ", "));
    }
    return loadTransferFunction(text);
}

} // namespace vs::render
