// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dirent.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

namespace vs {

// What lies in a folder, in no order; nothing, and `fault` says why, where it cannot be read. The iterators
// of libstdc++ 12 end the program where they find no memory for a name: parts of them may not throw.
inline std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder,
                                                    std::error_code& fault) {
    const auto close = [](DIR* open) { ::closedir(open); };
    const std::unique_ptr<DIR, decltype(close)> open(::opendir(folder.c_str()), close);
    std::vector<std::filesystem::path> entries;
    fault = open == nullptr ? std::error_code(errno, std::generic_category()) : std::error_code();
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
inline std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder) {
    std::error_code ignored;
    return entriesOf(folder, ignored);
}

// Removes a file, or a folder with all that lies in it, as far as that can be done. Links are not followed.
inline void removeAll(const std::filesystem::path& path) noexcept {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) {
        return;
    }
    if (S_ISDIR(status.st_mode)) {
        try {
            for (const auto& entry : entriesOf(path)) {
                removeAll(entry);
            }
        } catch (const std::bad_alloc&) { // then it stays, with what is in it
        }
    }
    ::remove(path.c_str());
}

} // namespace vs
