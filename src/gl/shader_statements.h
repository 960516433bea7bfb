// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

// What a shader text consists of. Internal to this folder.
namespace vs::gl {

using Tokens = std::vector<std::string_view>;
using TokenSpan = std::span<const std::string_view>;

// A declaration or a function at the outermost level of a shader.
struct Statement {
    TokenSpan head; // all before the braces; all of it if it has none
    TokenSpan body; // what is within the braces
    TokenSpan tail; // what stands between the braces and the semicolon
    bool hasBraces = false;
};

// The statements of a text without directives (gl/shader_text.h) that compiles.
std::vector<Statement> statementsOf(TokenSpan tokens);

bool has(TokenSpan tokens, std::string_view token);
bool isFunction(const Statement& statement);
// The place in its head of a function's name: before its parameters.
std::size_t placeOfName(TokenSpan head);
// The name that a declaration of one variable ends with, before the lengths of an array and its value.
std::string_view declaredName(TokenSpan head);
// The names of a block's members; others may be among them.
Tokens memberNames(const Statement& block);

// The index behind layout(...), or 0 if a declaration has none.
std::size_t behindLayout(TokenSpan head);
// The index behind the bracket that closes the one at `open`; `pair` are both brackets.
std::size_t behindPair(TokenSpan tokens, std::size_t open, std::string_view pair);

} // namespace vs::gl
