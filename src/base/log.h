// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace vs {

// How much is told to whoever runs the program, on standard error, one line a message. The environment
// variable VOLUME_STUDIO_LOG chooses it: "notice" (as without it), "performance" or "debug", each with all
// that those before it have.
enum class LogLevel {
    Notice,      // what was done with unusual input
    Performance, // what the driver says is slow
    Debug        // whatever else the driver and the libraries that read files say
};

[[nodiscard]] bool isLogged(LogLevel level);
// Writes a message if its level is logged: "note: ...", "performance: ...", "debug: ...".
void tell(LogLevel level, std::string_view message);
inline void logNotice(std::string_view message) { tell(LogLevel::Notice, message); }

} // namespace vs
