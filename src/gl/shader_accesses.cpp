// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_accesses.h"

#include "base/error.h"
#include "gl/shader_text.h"

#include <algorithm>
#include <set>
#include <span>
#include <vector>

namespace vs::gl {

namespace {

using Tokens = std::vector<std::string_view>;
using TokenSpan = std::span<const std::string_view>;

// A declaration or a function at the outermost level of a shader.
struct Statement {
    TokenSpan head; // all before the braces; all of it if it has none
    TokenSpan body; // what is within the braces
    TokenSpan tail; // what stands between the braces and the semicolon
    bool hasBraces = false;
};

bool has(TokenSpan tokens, std::string_view token) {
    return std::find(tokens.begin(), tokens.end(), token) != tokens.end();
}

bool isFunction(const Statement& s) { return s.hasBraces && s.head.back() == ")"; }

// The index behind the bracket that closes the one at `open`, which is counted by both kinds of `pair`.
std::size_t behindPair(TokenSpan tokens, std::size_t open, std::string_view pair) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        depth += tokens[i] == pair.substr(0, 1) ? 1 : tokens[i] == pair.substr(1, 1) ? -1 : 0;
        if (depth == 0) {
            return i + 1;
        }
    }
    return tokens.size();
}

// The index behind layout(...), or 0 if a declaration has none.
std::size_t behindLayout(TokenSpan head) {
    return !head.empty() && head[0] == "layout" ? behindPair(head, 1, "()") : 0;
}

std::vector<Statement> statementsOf(TokenSpan tokens) {
    std::vector<Statement> out;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] == ";") {
            if (i > begin) {
                out.push_back({tokens.subspan(begin, i - begin), {}, {}, false});
            }
            begin = i + 1;
        } else if (tokens[i] == "{" && i > begin) {
            const std::size_t behind = behindPair(tokens, i, "{}");
            Statement& s = out.emplace_back();
            s.hasBraces = true;
            s.head = tokens.subspan(begin, i - begin);
            s.body = tokens.subspan(i + 1, behind - i - 2);
            std::size_t end = behind;
            while (!isFunction(s) && end < tokens.size() && tokens[end] != ";") {
                ++end;
            }
            s.tail = tokens.subspan(behind, end - behind);
            begin = isFunction(s) ? behind : end + 1;
            i = begin - 1;
        }
    }
    return out;
}

// The name of a function: what stands before its parameters.
std::size_t placeOfName(TokenSpan head) {
    int depth = 0;
    for (std::size_t i = head.size(); i-- > 0;) {
        depth += head[i] == ")" ? 1 : head[i] == "(" ? -1 : 0;
        if (depth == 0) {
            return i == 0 ? 0 : i - 1;
        }
    }
    return 0;
}

// The names that main() reaches.
std::set<std::string_view> reachedNames(const std::vector<Statement>& statements, const Tokens& macroTokens) {
    std::multimap<std::string_view, TokenSpan> functions;
    std::vector<std::string_view> waiting{"main"};
    std::set<std::string_view> reached{"main"};
    const auto reach = [&](TokenSpan tokens) {
        for (const std::string_view token : tokens) {
            if (isName(token) && reached.insert(token).second) {
                waiting.push_back(token);
            }
        }
    };
    reach(macroTokens);
    for (const Statement& s : statements) {
        if (isFunction(s)) {
            const std::size_t name = placeOfName(s.head);
            functions.emplace(s.head[name], s.body);
            reach(s.head.first(name)); // a macro that makes a function may stand before this one
        } else {
            const std::size_t begin = behindLayout(s.head);
            reach(s.head.subspan(std::find(s.head.begin() + std::ptrdiff_t(begin), s.head.end(), "=") -
                                 s.head.begin())); // an initial value
        }
    }
    while (!waiting.empty()) {
        const std::string_view name = waiting.back();
        waiting.pop_back();
        const auto [first, last] = functions.equal_range(name);
        for (auto it = first; it != last; ++it) {
            reach(it->second);
        }
    }
    return reached;
}

// The name that a declaration of one variable ends with, before the lengths of an array and its value.
std::string_view declaredName(TokenSpan head) {
    std::string_view name;
    for (std::size_t i = behindLayout(head); i < head.size() && head[i] != "[" && head[i] != "="; ++i) {
        name = head[i];
    }
    return name;
}

bool namesAMember(const Statement& block, const std::set<std::string_view>& reached) {
    for (std::size_t i = 0; i + 1 < block.body.size(); ++i) {
        const std::string_view next = block.body[i + 1];
        if ((next == "[" || next == ";" || next == ",") && reached.contains(block.body[i])) {
            return true;
        }
    }
    return std::any_of(block.tail.begin(), block.tail.end(), // the name of an instance
                       [&](std::string_view t) { return reached.contains(t); });
}

Tokens tokensOfMacros(const Definitions& macros) {
    Tokens out;
    for (const auto& [name, text] : macros) {
        const Tokens tokens = tokensOf(text);
        out.insert(out.end(), tokens.begin(), tokens.end());
    }
    return out;
}

std::size_t bytesOfType(std::string_view type) {
    static const std::map<std::string_view, std::size_t> kBytes{
        {"uint", 4},  {"int", 4},    {"float", 4},  {"bool", 4},  {"vec2", 8},   {"ivec2", 8}, {"uvec2", 8},
        {"vec3", 12}, {"ivec3", 12}, {"uvec3", 12}, {"vec4", 16}, {"ivec4", 16}, {"uvec4", 16}};
    const auto found = kBytes.find(type);
    if (found == kBytes.end()) {
        throw GlError("shared memory of type {}: the bytes of this type are not known; add it to "
                      "gl/shader_accesses.cpp",
                      type);
    }
    return found->second;
}

} // namespace

std::map<std::string, DeclaredAccess, std::less<>> declaredAccesses(std::string_view source) {
    const ActiveText active = activeText(source);
    const Tokens tokens = tokensOf(active.text);
    const std::vector<Statement> statements = statementsOf(tokens);
    const auto reached = reachedNames(statements, tokensOfMacros(active.macros));
    std::map<std::string, DeclaredAccess, std::less<>> out;
    for (const Statement& s : statements) {
        const bool isStorage = has(s.head, "buffer");
        if (isFunction(s) || (!isStorage && !has(s.head, "uniform"))) {
            continue;
        }
        const bool isBlock = s.hasBraces;
        const std::string_view name = isBlock ? s.head.back() : declaredName(s.head);
        const bool isImage = !isBlock && std::any_of(s.head.begin(), s.head.end(), [](std::string_view t) {
            return t.starts_with("image") || t.starts_with("uimage") || t.starts_with("iimage");
        });
        out[std::string(name)] = {!has(s.head, "writeonly"),
                                  (isStorage || isImage) && !has(s.head, "readonly"),
                                  isBlock ? namesAMember(s, reached) : reached.contains(name)};
    }
    return out;
}

std::size_t sharedBytes(std::string_view source) {
    const ActiveText active = activeText(source);
    const Tokens tokens = tokensOf(active.text);
    Definitions constants = active.macros;
    std::size_t bytes = 0;
    for (const Statement& s : statementsOf(tokens)) {
        const auto equals = std::find(s.head.begin(), s.head.end(), "=");
        if (s.head.front() == "const" && equals != s.head.end()) {
            std::string& value = constants[std::string(*(equals - 1))];
            std::for_each(equals + 1, s.head.end(), [&](std::string_view t) { value.append(t).append(" "); });
        }
        if (s.head.front() != "shared" || s.head.size() < 3) {
            continue;
        }
        std::size_t count = bytesOfType(s.head[1]);
        for (std::size_t i = 3; i < s.head.size(); i = behindPair(s.head, i, "[]")) {
            std::string length;
            for (std::size_t k = i + 1; k + 1 < behindPair(s.head, i, "[]"); ++k) {
                length.append(s.head[k]).append(" ");
            }
            const long value = evaluate(length, constants).value_or(0);
            if (s.head[i] != "[" || value <= 0) {
                throw GlError("shared {}: its length '{}' is not known", s.head[2], length);
            }
            count *= std::size_t(value);
        }
        bytes += count;
    }
    return bytes;
}

} // namespace vs::gl
