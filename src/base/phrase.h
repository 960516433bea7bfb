// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

// Marks a text that people read, so that translators are shown it (tools/update_translations.sh): the context
// that it is translated in, which is "library" for all of src, and the English text.
#define VS_TEXT(context, text) text

namespace vs {

// Something said to people: an English text, which is also what its translation is found by, with %1, %2, ...
// where values stand, and the values.
struct Phrase {
    const char* text = "";
    std::vector<std::string> values = {};

    [[nodiscard]] bool isEmpty() const { return *text == '\0'; }
    [[nodiscard]] std::string english() const;
};

// A phrase with its values, each written as it is.
template <typename... Values>
Phrase say(const char* text, const Values&... values) {
    return {text, {fmt::format("{}", values)...}};
}

} // namespace vs
