// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace vs {

// Messages for whoever runs the program, on standard error, one line each. Notices tell what was done with
// unusual input; debug lines appear only when VOLUME_STUDIO_LOG=debug is set.
void logNotice(std::string_view message);
void logDebug(std::string_view message);

} // namespace vs
