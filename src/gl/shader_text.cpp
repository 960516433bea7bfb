// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace vs::gl {

bool isOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

namespace {

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isSpace(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

// Takes the first word of a text off it.
std::string_view takeWord(std::string_view& text) {
    text = trimmed(text);
    std::size_t length = 0;
    while (length < text.size() && isOfName(text[length])) {
        ++length;
    }
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

// The operators of two operands, those that bind least first; of those that begin alike the longer one first.
constexpr std::array<std::array<std::string_view, 4>, 6> kOperators{
    {{"||"}, {"&&"}, {"==", "!="}, {"<=", ">=", "<", ">"}, {"+", "-"}, {"*", "/"}}};

long apply(std::string_view sign, long a, long b) {
    if (sign == "||" || sign == "&&") {
        return static_cast<long>(sign == "||" ? a != 0 || b != 0 : a != 0 && b != 0);
    }
    if (sign == "==" || sign == "!=") {
        return static_cast<long>((a == b) == (sign == "=="));
    }
    if (sign.front() == '<' || sign.front() == '>') {
        return static_cast<long>((sign.front() == '<' ? a < b : a > b) || (sign.size() == 2 && a == b));
    }
    if (sign == "+" || sign == "-") {
        return sign == "+" ? a + b : a - b;
    }
    return sign == "*" ? a * b : b == 0 ? 0 : a / b;
}

class Expression {
public:
    Expression(std::string_view text, const Definitions& definitions, int depth)
        : rest_(text), definitions_(definitions), depth_(depth) {}

    std::optional<long> value() {
        const long result = chain(0);
        rest_ = trimmed(rest_);
        return isBroken_ || !rest_.empty() ? std::nullopt : std::optional(result);
    }

private:
    bool take(std::string_view sign) {
        rest_ = trimmed(rest_);
        if (!rest_.starts_with(sign)) {
            return false;
        }
        rest_.remove_prefix(sign.size());
        return true;
    }

    // Operands joined by the operators of one level, from left to right.
    long chain(std::size_t level) {
        if (level == kOperators.size()) {
            return operand();
        }
        long result = chain(level + 1);
        for (bool goesOn = true; goesOn && !isBroken_;) {
            goesOn = false;
            for (const std::string_view sign : kOperators.at(level)) {
                if (!sign.empty() && take(sign)) {
                    result = apply(sign, result, chain(level + 1));
                    goesOn = true;
                    break;
                }
            }
        }
        return result;
    }

    long operand() {
        if (take("!")) {
            return operand() == 0 ? 1 : 0;
        }
        if (take("-")) {
            return -operand();
        }
        if (take("(")) {
            const long result = chain(0);
            isBroken_ = isBroken_ || !take(")");
            return result;
        }
        const std::string_view word = takeWord(rest_);
        if (word.empty()) {
            isBroken_ = true;
            return 0;
        }
        return word == "defined" ? isDefined() : valueOf(word);
    }

    long isDefined() {
        const bool isOpen = take("(");
        const std::string_view name = takeWord(rest_);
        isBroken_ = isBroken_ || name.empty() || (isOpen && !take(")"));
        return static_cast<long>(definitions_.contains(name));
    }

    long valueOf(std::string_view word) {
        if (std::isdigit(static_cast<unsigned char>(word.front())) != 0) {
            const int base = word.starts_with("0x") ? 16 : 10;
            const std::string_view digits = word.substr(base == 16 ? 2 : 0);
            long number = 0;
            const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number, base);
            const std::string_view suffix(end, std::size_t(digits.end() - end));
            isBroken_ = isBroken_ || error != std::errc() || !(suffix.empty() || suffix == "u");
            return number;
        }
        const auto found = definitions_.find(word);
        if (found == definitions_.end() || depth_ > 16) { // a name that stands for itself
            return 0;
        }
        const auto result = Expression(found->second, definitions_, depth_ + 1).value();
        isBroken_ = isBroken_ || !result;
        return result.value_or(0);
    }

    std::string_view rest_;
    const Definitions& definitions_;
    int depth_;
    bool isBroken_ = false;
};

// The branches of #if that a place of the text lies in.
class Branches {
public:
    [[nodiscard]] bool isTaken() const {
        return std::all_of(open_.begin(), open_.end(), [](const Branch& b) { return b.isTaken; });
    }
    void begin(bool isTaken) { open_.push_back({isTaken, isTaken}); }
    void next(bool isTaken) {
        if (!open_.empty()) {
            open_.back().isTaken = isTaken && !open_.back().wasTaken;
            open_.back().wasTaken = open_.back().wasTaken || isTaken;
        }
    }
    void end() {
        if (!open_.empty()) {
            open_.pop_back();
        }
    }

private:
    struct Branch {
        bool isTaken = false;
        bool wasTaken = false; // this branch, or one before it
    };
    std::vector<Branch> open_;
};

// One directive, without its #.
void follow(std::string_view directive, Definitions& macros, Branches& branches) {
    const std::string_view word = takeWord(directive);
    const auto holds = [&] { return evaluate(directive, macros).value_or(0) != 0; };
    if (word == "ifdef" || word == "ifndef") {
        branches.begin(macros.contains(trimmed(directive)) == (word == "ifdef"));
    } else if (word == "if") {
        branches.begin(holds());
    } else if (word == "elif" || word == "else") {
        branches.next(word == "else" || holds());
    } else if (word == "endif") {
        branches.end();
    } else if (word == "define" && branches.isTaken()) {
        const std::string name(takeWord(directive));
        macros[name] = std::string(trimmed(directive));
    } else if (word == "undef" && branches.isTaken()) {
        macros.erase(std::string(trimmed(directive)));
    }
}

} // namespace

std::string withoutComments(std::string_view source) {
    std::string out;
    while (!source.empty()) {
        std::size_t taken = 1;
        if (source.starts_with("//")) {
            taken = std::min(source.find('\n'), source.size());
            out += ' ';
        } else if (source.starts_with("/*")) {
            const auto end = source.find("*/", 2);
            taken = end == source.npos ? source.size() : end + 2;
            out += ' ';
        } else {
            out += source.front();
        }
        source.remove_prefix(taken);
    }
    return out;
}

std::optional<long> evaluate(std::string_view expression, const Definitions& definitions) {
    return Expression(expression, definitions, 0).value();
}

ActiveText activeText(std::string_view source) {
    std::string joined;
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source.substr(i).starts_with("\\\n")) {
            ++i; // the line goes on
        } else {
            joined += source[i];
        }
    }
    const std::string text = withoutComments(joined);
    ActiveText out;
    Branches branches;
    for (std::string_view rest = text; !rest.empty();) {
        const auto end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.starts_with('#')) {
            follow(line.substr(1), out.macros, branches);
        } else if (branches.isTaken()) {
            out.text.append(line).append("\n");
        }
    }
    return out;
}

std::vector<std::string_view> tokensOf(std::string_view text) {
    std::vector<std::string_view> tokens;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        std::size_t length = 1;
        while (isOfName(text.front()) && length < text.size() && isOfName(text[length])) {
            ++length;
        }
        tokens.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return tokens;
}

bool isName(std::string_view token) {
    return !token.empty() && isOfName(token.front()) &&
           std::isdigit(static_cast<unsigned char>(token.front())) == 0;
}

} // namespace vs::gl
