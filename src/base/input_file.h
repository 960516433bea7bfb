// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace vs {

// Why a path names nothing that can be read as a file, as a sentence's end: "is a folder"; empty: it does. A
// pipe or a device would be waited for without end, or never end. To be asked before it is opened.
inline std::string whyNoFile(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_regular_file(status)) {
        return {};
    }
    if (std::filesystem::is_directory(status)) {
        return "is a folder";
    }
    return std::filesystem::exists(status) ? "is no file but a pipe or a device" : "cannot be read";
}

} // namespace vs
