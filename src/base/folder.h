// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dirent.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace vs {

// What lies in a folder, in no order; nothing where it cannot be read. The iterators of libstdc++ 12 end the
// program where they find no memory for the next name: their increment() may not throw.
inline std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder) {
    const auto close = [](DIR* open) { ::closedir(open); };
    const std::unique_ptr<DIR, decltype(close)> open(::opendir(folder.c_str()), close);
    std::vector<std::filesystem::path> entries;
    if (open == nullptr) {
        return entries;
    }
    while (const dirent* entry = ::readdir(open.get())) {
        const std::string_view name(entry->d_name);
        if (name != "." && name != "..") {
            entries.push_back(folder / name);
        }
    }
    return entries;
}

} // namespace vs
