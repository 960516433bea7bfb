// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>

namespace vs::test {

// Where real scans lie that are not part of the repository. They, or the folder, may be missing.
inline std::filesystem::path dataFolder() {
    const char* given = std::getenv("VOLUME_STUDIO_TEST_DATA");
    return given != nullptr ? given
                            : std::filesystem::path(VOLUME_STUDIO_SOURCE_DIR) / ".." / "shared" / "data";
}

} // namespace vs::test
