// SPDX-License-Identifier: Apache-2.0
#include "marking/pen_letters.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace vs::marking {

namespace {

constexpr double kHeight = 8;    // of a capital, in the units of kLetters
constexpr double kBetween = 2.6; // letters
constexpr double kSpace = 3;     // as wide as a blank

// The lines of each letter: places as two digits, to the right and up, lines divided by bars; those that
// begin with ~ are control polygons of curves.
const std::map<std::string_view, std::string_view>& letters() {
    static const std::map<std::string_view, std::string_view> kLetters{
        {"A", "00 38 60|13 53"},
        {"B", "00 08|~08 48 68 66 64 44 04|~04 44 64 62 60 40 00"},
        {"C", "~67 58 38 08 04 00 30 50 61"},
        {"D", "00 08|~08 38 68 64 60 30 00"},
        {"E", "68 08 00 60|04 44"},
        {"F", "68 08 00|04 44"},
        {"G", "~67 58 38 08 04 00 30 60 63|63 43"},
        {"H", "00 08|60 68|04 64"},
        {"I", "30 38"},
        {"J", "~58 54 51 50 30 00 02"},
        {"K", "00 08|68 03|25 60"},
        {"L", "08 00 60"},
        {"M", "00 08 34 68 60"},
        {"N", "00 08 60 68"},
        {"O", "~38 08 04 00 30 60 64 68 38"},
        {"P", "00 08|~08 48 68 66 64 44 04"},
        {"Q", "~38 08 04 00 30 60 64 68 38|42 60"},
        {"R", "00 08|~08 48 68 66 64 44 04|34 60"},
        {"S", "~67 58 38 08 06 04 34 64 62 60 30 10 01"},
        {"T", "08 68|38 30"},
        {"U", "~08 04 00 30 60 64 68"},
        {"V", "08 30 68"},
        {"W", "08 10 35 50 68"},
        {"X", "08 60|00 68"},
        {"Y", "08 34 68|34 30"},
        {"Z", "08 68 00 60"},
        {"\u00c4", "00 38 60|13 53|19 19|59 59"},
        {"\u00d6", "~38 08 04 00 30 60 64 68 38|19 19|59 59"},
        {"\u00dc", "~08 04 00 30 60 64 68|19 19|59 59"},
        {"0", "~38 08 04 00 30 60 64 68 38"},
        {"1", "16 38 30"},
        {"2", "~06 08 38 68 65 33 00|00 60"},
        {"3", "~07 18 38 68 66 64 34|~34 64 62 60 30 10 01"},
        {"4", "40 48 02 62"},
        {"5", "58 18 14|~14 35 65 62 60 30 10 01"},
        {"6", "~58 28 05 02 00 30 60 63 65 35 03"},
        {"7", "08 68 20"},
        {"8", "~38 08 06 04 34 64 66 68 38|~34 04 02 00 30 60 62 64 34"},
        {"9", "~10 40 63 66 68 38 08 05 03 33 65"},
        {"+", "14 54|36 32"},
        {"-", "14 54"},
        {"\u00d7", "16 52|12 56"},
        {"=", "15 55|13 53"},
        {"/", "00 68"},
        {".", "30 30"},
        {",", "31 20"},
        {":", "36 36|32 32"},
        {"?", "~06 08 38 68 66 35 33|30 30"},
        {"!", "38 33|30 30"},
        {"*", "37 31|15 53|13 55"},
        {"<", "57 14 51"},
        {">", "17 54 11"},
        {"(", "~48 26 24 22 40"},
        {")", "~28 46 44 42 20"},
        {"\u00b0", "~38 28 27 26 36 46 47 48 38"},
        {" ", ""},
    };
    return kLetters;
}

// The characters of a text, small letters as capitals.
std::vector<std::string> charactersOf(const std::string& utf8) {
    static const std::map<std::string, std::string> kCapitals{
        {"\u00e4", "\u00c4"}, {"\u00f6", "\u00d6"}, {"\u00fc", "\u00dc"}};
    std::vector<std::string> all;
    for (const char byte : utf8) {
        const bool goesOn = (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
        if (goesOn && !all.empty()) {
            all.back() += byte;
        } else {
            const bool isSmall = byte >= 'a' && byte <= 'z';
            all.emplace_back(1, isSmall ? char(byte - 'a' + 'A') : byte);
        }
    }
    for (std::string& one : all) {
        const auto capital = kCapitals.find(one);
        one = capital != kCapitals.end() ? capital->second : one;
    }
    return all;
}

// Cuts corners (Chaikin 1974) of an open line, whose ends stay.
std::vector<glm::dvec2> rounded(std::vector<glm::dvec2> line) {
    constexpr int times = 3;
    for (int n = 0; n < times; ++n) {
        std::vector<glm::dvec2> next{line.front()};
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            next.push_back(0.75 * line[i] + 0.25 * line[i + 1]);
            next.push_back(0.25 * line[i] + 0.75 * line[i + 1]);
        }
        next.push_back(line.back());
        line = std::move(next);
    }
    return line;
}

PenLines linesOf(std::string_view drawn) {
    PenLines lines;
    while (!drawn.empty()) {
        const std::size_t end = std::min(drawn.find('|'), drawn.size());
        std::string_view one = drawn.substr(0, end);
        drawn.remove_prefix(std::min(end + 1, drawn.size()));
        const bool isCurve = one.front() == '~';
        std::vector<glm::dvec2> line;
        for (std::size_t i = isCurve ? 1 : 0; i + 1 < one.size(); i += 3) {
            line.emplace_back(one[i] - '0', one[i + 1] - '0');
        }
        lines.push_back(isCurve ? rounded(std::move(line)) : std::move(line));
    }
    return lines;
}

// From where to where lines reach, to the right.
std::pair<double, double> extentOf(const PenLines& lines) {
    std::pair<double, double> extent(1e9, -1e9);
    for (const auto& line : lines) {
        for (const glm::dvec2& place : line) {
            extent = {std::min(extent.first, place.x), std::max(extent.second, place.x)};
        }
    }
    return lines.empty() ? std::pair(0.0, kSpace) : extent;
}

} // namespace

PenLines penLetters(const std::string& utf8) {
    PenLines all;
    double right = -kBetween; // of what is written so far
    for (const std::string& character : charactersOf(utf8)) {
        const auto letter = letters().find(character);
        if (letter == letters().end()) {
            continue;
        }
        PenLines lines = linesOf(letter->second);
        const auto [from, to] = extentOf(lines);
        const double left = right + kBetween - from;
        right = left + to;
        for (auto& line : lines) {
            for (glm::dvec2& place : line) {
                place.x += left;
            }
            all.push_back(std::move(line));
        }
    }
    const glm::dvec2 middle(0.5 * right, 0.5 * kHeight);
    for (auto& line : all) {
        for (glm::dvec2& place : line) {
            place = glm::dvec2(place.x - middle.x, middle.y - place.y) / kHeight;
        }
    }
    return all;
}

std::string unwritable(const std::string& utf8) {
    const auto characters = charactersOf(utf8);
    const auto found = std::find_if(characters.begin(), characters.end(),
                                    [](const std::string& one) { return letters().count(one) == 0; });
    return found != characters.end() ? *found : std::string();
}

} // namespace vs::marking
