// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace vs {

std::string inOneLine(std::string text) {
    const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
    std::replace_if(text.begin(), text.end(), isControl, '?');
    return text;
}

std::string readableName(std::string_view name, std::size_t most) {
    // The library that reads and writes all our texts decides what is UTF-8.
    const nlohmann::json written(inOneLine(std::string(name)));
    const std::string json = written.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    auto text = nlohmann::json::parse(json).get<std::string>();
    const auto isInCharacter = [&](std::size_t at) { return (std::uint8_t(text[at]) & 0xC0U) == 0x80U; };
    if (text.size() > most) {
        while (most > 0 && isInCharacter(most)) {
            --most;
        }
        text.resize(most);
    }
    return text;
}

} // namespace vs
