// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace vs {

// A file that was compiled into the program (cmake/EmbedTexts.cmake): its name without extension, and its
// text.
struct EmbeddedText {
    std::string_view name;
    std::string_view text;
};

} // namespace vs
