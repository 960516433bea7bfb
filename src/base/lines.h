// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <algorithm>
#include <filesystem>
#include <ios>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace vs {

// The parts of a text between separators; what follows the last separator counts only where there is
// something.
inline std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

// The words of a text, between white space.
inline std::vector<std::string> words(std::string_view text) {
    constexpr std::string_view kSpace = " \t\n\v\f\r";
    std::vector<std::string> all;
    for (std::size_t begin = text.find_first_not_of(kSpace); begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
        all.emplace_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(kSpace, end);
    }
    return all;
}

// Reads a line, or says that there is none. std::getline() takes the want of memory and a failing disk for
// the end of the file; this one throws std::bad_alloc, or ReadError, which names the file.
inline bool nextLine(std::istream& in, std::string& line, const std::filesystem::path& path) {
    const auto before = in.exceptions();
    try {
        in.exceptions(std::ios::badbit);
        const bool isThere = bool(std::getline(in, line));
        in.exceptions(before);
        return isThere;
    } catch (const std::ios_base::failure& failure) {
        throw ReadError("{}: it cannot be read to its end ({})", path.string(), failure.code().message());
    }
}

} // namespace vs
