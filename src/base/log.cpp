// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"

#include <cstdio>
#include <cstdlib>

namespace vs {

void logNotice(std::string_view message) { fmt::print(stderr, "note: {}\n", message); }

void logDebug(std::string_view message) {
    static const bool enabled = [] {
        const char* level = std::getenv("VOLUME_STUDIO_LOG");
        return level != nullptr && std::string_view(level) == "debug";
    }();
    if (enabled) {
        fmt::print(stderr, "debug: {}\n", message);
    }
}

} // namespace vs
