// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace vs {

namespace {

constexpr std::array<const char*, 3> kNames{"notice", "performance", "debug"};
constexpr std::array<const char*, 3> kBeginnings{"note", "performance", "debug"};

// Takes no memory: what is told may be that there is none.
void print(LogLevel level, std::string_view message) {
    std::fprintf(stderr, "%s: %.*s\n", kBeginnings[std::size_t(level)], int(message.size()), message.data());
}

LogLevel chosenLevel() {
    const char* chosen = std::getenv("VOLUME_STUDIO_LOG");
    for (std::size_t i = 0; chosen != nullptr && i < kNames.size(); ++i) {
        if (std::string_view(chosen) == kNames[i]) {
            return LogLevel(i);
        }
    }
    if (chosen != nullptr && *chosen != '\0') {
        print(LogLevel::Notice,
              fmt::format("VOLUME_STUDIO_LOG={} is not known; choose notice, performance or debug", chosen));
    }
    return LogLevel::Notice;
}

} // namespace

bool isLogged(LogLevel level) {
    static const LogLevel chosen = chosenLevel();
    return level <= chosen;
}

void tell(LogLevel level, std::string_view message) {
    if (isLogged(level)) {
        print(level, message);
    }
}

} // namespace vs
