// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace vs {

// Writes a file so that it is either whole or untouched: `write` fills a temporary file in the same folder
// (same extension, so that writers which look at it choose the right format), which is synced and renamed
// over `path` (or what outputFile() says). The temporary file is removed when anything fails. Throws
// WriteError naming `path`.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

// A file and what fills a temporary one in its place, as above.
struct FileWriting {
    std::filesystem::path path;
    std::function<void(const std::filesystem::path& temporary)> write;
};
// Writes files that belong together: all are filled and synced before the first is renamed, so that a full
// disk leaves the old ones.
void writeAllAtomically(std::span<const FileWriting> files);

// The file that writing to `path` replaces: where links point, so that they stay. Throws WriteError when what
// is there already is no file: a folder, a pipe, a device.
std::filesystem::path outputFile(const std::filesystem::path& path);

// What fills a file with bytes, for FileWriting.
std::function<void(const std::filesystem::path& temporary)> writingOf(std::string content);

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);
void writeFileAtomically(const std::filesystem::path& path, const std::string& content);

} // namespace vs
