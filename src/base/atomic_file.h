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
// over `path`. The temporary file is removed when anything fails. Throws WriteError naming `path`.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);
void writeFileAtomically(const std::filesystem::path& path, const std::string& content);

} // namespace vs
