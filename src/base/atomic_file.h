// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/folder.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>

namespace vs {

// Writes a file so that it is either whole or untouched: `write` fills a temporary file in the same folder
// (same extension, so that writers which look at it choose the right format), which is synced and renamed
// over `path` (or what outputFile() says). The temporary file is removed when anything fails, and those that
// killed runs of the program have left in the folder before. Throws WriteError naming `path`.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

// A file and what fills a temporary one in its place, as above.
struct FileWriting {
    std::filesystem::path path;
    std::function<void(const std::filesystem::path& temporary)> write;
};
// Writes files that belong together: all are filled and synced before the first is renamed, and if a later
// one cannot be renamed the earlier ones are put back, so that either all are new or none (but on file
// systems that cannot exchange names, where those that were renamed stay). What goes wrong is said of the
// last one, which is the one that the person has named.
void writeAllAtomically(std::span<const FileWriting> files);

// The file that writing to `path` replaces: where links point, so that they stay. Throws WriteError when what
// is there already is no file: a folder, a pipe, a device.
std::filesystem::path outputFile(const std::filesystem::path& path);

// The hidden name beside `target` under which it is written until it is whole, with the extension of `path`:
// ".turn.part123@a0b1c2.webm". Throws WriteError naming `path`, which is how the person calls the target,
// when there is no folder for it. Removes what killed runs of the program have left in that folder.
std::filesystem::path temporaryBeside(const std::filesystem::path& target, const std::filesystem::path& path);

// Why `temporary` could not be filled, in one line: what the system says where it takes no more bytes of it
// (a full disk, a folder that may only be read), which libraries do not always tell; else `said`.
std::string reasonNotFilled(const std::filesystem::path& temporary, std::string said);
// Throws WriteError: `path` cannot be written for that reason, and what to do about it.
[[noreturn]] void refuseToWrite(const std::filesystem::path& path, const std::string& reason);

// A file, or a folder with what is in it, that is removed in the end unless it has moved away.
class Leftover {
public:
    explicit Leftover(std::filesystem::path path) : path_(std::move(path)) {}
    ~Leftover() { removeAll(path_); }
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

// What fills a file with bytes, for FileWriting.
std::function<void(const std::filesystem::path& temporary)> writingOf(std::string content);

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);
void writeFileAtomically(const std::filesystem::path& path, const std::string& content);

} // namespace vs
