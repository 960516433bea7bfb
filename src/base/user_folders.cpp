// SPDX-License-Identifier: Apache-2.0
#include "base/user_folders.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace vs {

namespace {

std::filesystem::path homeFolder() {
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return home;
    }
    const passwd* user = getpwuid(getuid());
    return user != nullptr ? user->pw_dir : "/";
}

// What the variable says if that is an absolute path, else that folder below the person's home.
std::filesystem::path folderOf(const char* variable, const std::filesystem::path& belowHome) {
    const char* given = std::getenv(variable);
    const std::filesystem::path chosen = given != nullptr ? given : "";
    return chosen.is_absolute() ? chosen : homeFolder() / belowHome;
}

} // namespace

std::filesystem::path stateFolder() {
    return folderOf("XDG_STATE_HOME", std::filesystem::path(".local") / "state");
}
std::filesystem::path cacheFolder() { return folderOf("XDG_CACHE_HOME", ".cache"); }

} // namespace vs
