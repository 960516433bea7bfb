// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

// Where a person's files of a kind lie, by the XDG Base Directory Specification. The folders need not be
// there.
namespace vs {

// What a program goes on with when it is started again.
std::filesystem::path stateFolder();
// What is only there to save time, and may be removed.
std::filesystem::path cacheFolder();

} // namespace vs
