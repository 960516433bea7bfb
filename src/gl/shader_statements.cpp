// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_statements.h"

#include "gl/shader_text.h"

#include <algorithm>

namespace vs::gl {

bool has(TokenSpan tokens, std::string_view token) {
    return std::find(tokens.begin(), tokens.end(), token) != tokens.end();
}

bool isFunction(const Statement& statement) { return statement.hasBraces && statement.head.back() == ")"; }

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

std::string_view declaredName(TokenSpan head) {
    std::string_view name;
    for (std::size_t i = behindLayout(head); i < head.size() && head[i] != "[" && head[i] != "="; ++i) {
        name = head[i];
    }
    return name;
}

Tokens memberNames(const Statement& block) {
    Tokens names;
    for (std::size_t i = 0; i + 1 < block.body.size(); ++i) {
        const std::string_view next = block.body[i + 1];
        if (isName(block.body[i]) && (next == "[" || next == ";" || next == ",")) {
            names.push_back(block.body[i]);
        }
    }
    return names;
}

} // namespace vs::gl
