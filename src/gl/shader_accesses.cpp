// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_accesses.h"

#include "base/error.h"
#include "gl/shader_statements.h"
#include "gl/shader_text.h"

#include <algorithm>
#include <set>

namespace vs::gl {

namespace {

// What main() reaches.
struct Reached {
    std::set<std::string_view> names;
    std::vector<TokenSpan> texts; // of functions
};

Reached reachedOf(const std::vector<Statement>& statements, TokenSpan macroTokens) {
    std::multimap<std::string_view, TokenSpan> functions;
    std::vector<std::string_view> waiting{"main"};
    Reached out{{"main"}, {}};
    const auto reach = [&](TokenSpan tokens) {
        for (const std::string_view token : tokens) {
            if (isName(token) && out.names.insert(token).second) {
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
            const auto begin = s.head.begin() + std::ptrdiff_t(behindLayout(s.head));
            reach({std::find(begin, s.head.end(), "="), s.head.end()}); // an initial value
        }
    }
    while (!waiting.empty()) {
        const std::string_view name = waiting.back();
        waiting.pop_back();
        const auto [first, last] = functions.equal_range(name);
        for (auto it = first; it != last; ++it) {
            reach(it->second);
            out.texts.push_back(it->second);
        }
    }
    return out;
}

// Whether the tokens from `at` on, behind a variable, assign to it: =, +=, ++ and so on.
bool isAssignedAt(TokenSpan text, std::size_t at) {
    const auto token = [&](std::size_t i) { return i < text.size() ? text[i] : std::string_view(); };
    const std::string_view sign = token(at);
    if (sign == "=") {
        return token(at + 1) != "=";
    }
    if (sign == "<" || sign == ">") {
        return token(at + 1) == sign && token(at + 2) == "=";
    }
    constexpr std::string_view kSigns = "+-*/%&|^";
    const bool isSign = sign.size() == 1 && kSigns.find(sign.front()) != kSigns.npos;
    const bool isTwice = (sign == "+" || sign == "-") && token(at + 1) == sign;
    return isSign && (token(at + 1) == "=" || isTwice);
}

// The name of the function that a variable is given to as an argument, and whether it is the first one.
struct Call {
    std::string_view function; // nothing if there is none
    bool isFirst = true;
};

Call callAround(TokenSpan text, std::size_t at) {
    Call call;
    int depth = 0; // of the brackets that close before `at`
    for (std::size_t i = at; i-- > 0;) {
        const std::string_view token = text[i];
        const bool opens = token == "(" || token == "[";
        if (token == ")" || token == "]") {
            ++depth;
        } else if (opens && depth > 0) {
            --depth;
        } else if (token == "(" && i > 0 && isName(text[i - 1])) {
            call.function = text[i - 1];
            return call;
        } else if (token == "[" || (!opens && std::string_view(";{}").find(token) != token.npos)) {
            return {}; // it is an index, or stands in no call
        } else if (token == "," && depth == 0) {
            call.isFirst = false;
        }
    }
    return {};
}

// Whether the variable that is named at `at` may be changed there, for members of blocks and for images.
// `changing` are functions of the shader's own that may change what they are given.
bool mayChangeAt(TokenSpan text, std::size_t at, const std::set<std::string_view>& changing) {
    std::size_t behind = at + 1;
    while (behind < text.size() && (text[behind] == "[" || text[behind] == ".")) {
        behind = text[behind] == "[" ? behindPair(text, behind, "[]") : behind + 2;
    }
    if (isAssignedAt(text, behind)) {
        return true;
    }
    if (at > 1 && text[at - 1] == text[at - 2] && (text[at - 1] == "+" || text[at - 1] == "-")) {
        return true;
    }
    const Call call = callAround(text, at);
    const bool isBuiltIn = call.function.starts_with("atomic") || call.function == "imageStore" ||
                           call.function.starts_with("imageAtomic");
    return (isBuiltIn && call.isFirst) || changing.contains(call.function);
}

bool mayChange(std::string_view name, const Reached& reach, TokenSpan macroTokens,
               const std::set<std::string_view>& changing) {
    if (has(macroTokens, name)) {
        return true; // where the macro is used is not looked for
    }
    return std::any_of(reach.texts.begin(), reach.texts.end(), [&](TokenSpan text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == name && mayChangeAt(text, i, changing)) {
                return true;
            }
        }
        return false;
    });
}

// The functions of a shader that may change what they are given: images, or arguments that go out.
std::set<std::string_view> changingFunctions(const std::vector<Statement>& statements) {
    std::set<std::string_view> names;
    for (const Statement& s : statements) {
        const bool changes = std::any_of(s.head.begin(), s.head.end(), [](std::string_view t) {
            return t == "out" || t == "inout" || t.find("image") != t.npos;
        });
        if (isFunction(s) && changes) {
            names.insert(s.head[placeOfName(s.head)]);
        }
    }
    return names;
}

Tokens tokensOfMacros(const Definitions& macros) {
    Tokens out;
    for (const auto& [name, text] : macros) {
        const Tokens tokens = tokensOf(text);
        out.insert(out.end(), tokens.begin(), tokens.end());
    }
    return out;
}

bool isImageType(std::string_view token) {
    return token.starts_with("image") || token.starts_with("uimage") || token.starts_with("iimage");
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
    const Tokens macroTokens = tokensOfMacros(active.macros);
    const std::vector<Statement> statements = statementsOf(tokens);
    const Reached reach = reachedOf(statements, macroTokens);
    const auto changing = changingFunctions(statements);
    std::map<std::string, DeclaredAccess, std::less<>> out;
    for (const Statement& s : statements) {
        const bool isStorage = has(s.head, "buffer");
        if (isFunction(s) || (!isStorage && !has(s.head, "uniform"))) {
            continue;
        }
        const bool isBlock = s.hasBraces;
        const std::string_view name = isBlock ? s.head.back() : declaredName(s.head);
        Tokens variables = isBlock ? memberNames(s) : Tokens{name};
        DeclaredAccess access{!has(s.head, "writeonly"), false, false};
        access.isUsed = std::any_of(variables.begin(), variables.end(),
                                    [&](std::string_view v) { return reach.names.contains(v); });
        const bool isInstance = std::any_of(s.tail.begin(), s.tail.end(), isName);
        if (isInstance) { // which the members are named through
            access.isUsed = reach.names.contains(s.tail.front());
        }
        if ((isStorage || std::any_of(s.head.begin(), s.head.end(), isImageType)) &&
            !has(s.head, "readonly")) {
            access.writes = isInstance || std::any_of(variables.begin(), variables.end(), [&](auto v) {
                                return mayChange(v, reach, macroTokens, changing);
                            });
        }
        out[std::string(name)] = access;
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
