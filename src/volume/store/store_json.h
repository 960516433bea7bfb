// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/json_file.h"
#include "base/json_reader.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// The small JSON files of a Zarr store. Internal to this folder.
namespace vs::volume {

// What `read` makes of a file. Whatever is wrong with it is thrown as ReadError.
template <typename Read>
auto readStoreFile(const std::filesystem::path& file, const std::string& wanted, const Read& read) {
    try {
        const auto json = readJsonFile(file, wanted, "OME-NGFF 0.4");
        return read(JsonReader(json, file.string()));
    } catch (const SessionError& wrong) {
        throw ReadError(wrong.what());
    }
}

// Writes such a file, and its folder where there is none. Throws WriteError.
void writeStoreFile(const std::filesystem::path& file, const nlohmann::ordered_json& json);

} // namespace vs::volume
