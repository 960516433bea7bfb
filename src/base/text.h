// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Texts from files, as people are shown them.
namespace vs {

// The text with control characters (ends of lines among them) replaced by '?', so that it is one line and
// does nothing to a terminal.
std::string inOneLine(std::string text);

// A name from a file as one line of UTF-8, which all that is saved must be: what is none becomes U+FFFD. What
// is longer than `most` bytes ends with the last character that fits.
std::string readableName(std::string_view name, std::size_t most);

} // namespace vs
