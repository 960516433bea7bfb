// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace vs {

// A text as a field of comma-separated values: one that holds a separator or a quote is quoted, as RFC 4180
// has it.
inline std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + '"';
}

} // namespace vs
