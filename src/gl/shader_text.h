// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vs::gl {

// A shader text in which each comment is a space, as the language has it.
std::string withoutComments(std::string_view source);

// Names and the texts that stand for them: macros, or constants.
using Definitions = std::map<std::string, std::string, std::less<>>;

// What a compiler sees of an expanded shader text: no comments, no directives, only the branches of #if that
// are taken. Macros are listed; where the text uses them they are left as they are.
struct ActiveText {
    std::string text;
    Definitions macros; // those with parameters too, by their names alone
};
ActiveText activeText(std::string_view source);

// The value of an integer expression as #if has it: numbers, names of `definitions` (others are 0),
// defined(), and ! - * / + comparisons && || and parentheses. Nothing for what is not such an expression.
std::optional<long> evaluate(std::string_view expression, const Definitions& definitions);

// Names, numbers, and each other character by itself, without white space.
std::vector<std::string_view> tokensOf(std::string_view text);

// Whether names may have this character.
bool isOfName(char c);

// Whether a token is a name, or a keyword.
bool isName(std::string_view token);

} // namespace vs::gl
