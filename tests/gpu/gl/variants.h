// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/shader_source.h"

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

// The variants of shaders that tests go through.
namespace vs::test {

inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

// The sets of defines that a shader's "// variants:" line names, or one without any.
inline std::vector<gl::Defines> variantsOf(const std::string& source) {
    constexpr std::string_view kBegin = "// variants:";
    const auto begin = source.find(kBegin);
    if (begin == source.npos) {
        return {gl::Defines{}};
    }
    const auto at = begin + kBegin.size();
    std::vector<gl::Defines> variants;
    for (const std::string& set : split(source.substr(at, source.find('\n', at) - at), ';')) {
        gl::Defines& defines = variants.emplace_back();
        std::istringstream words(set);
        for (std::string word; words >> word;) {
            const auto equals = word.find('=');
            defines.emplace_back(word.substr(0, equals), word.substr(equals + 1));
        }
    }
    return variants;
}

// A name for failures.
inline std::string textOf(const std::string& path, const gl::Defines& defines) {
    std::string text = path;
    for (const auto& [name, value] : defines) {
        text.append(" ").append(name).append("=").append(value);
    }
    return text;
}

} // namespace vs::test
