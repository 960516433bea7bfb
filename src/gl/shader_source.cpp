// SPDX-License-Identifier: Apache-2.0
#include "gl/shader_source.h"

#include "base/error.h"
#include "base/lines.h"
#include "gl/embedded_shaders.h"
#include "gl/shader_text.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

namespace vs::gl {

Defines switchesOn(std::initializer_list<std::pair<const char*, bool>> switches) {
    Defines defines;
    for (const auto& [name, isOn] : switches) {
        if (isOn) {
            defines.emplace_back(name, "1");
        }
    }
    return defines;
}

std::optional<std::string> findShader(const std::string& path) {
    if (const char* folder = std::getenv("VOLUME_STUDIO_SHADER_DIR")) {
        std::ifstream file(std::string(folder) + "/" + path);
        if (file) {
            std::stringstream text;
            text << file.rdbuf();
            return text.str();
        }
    }
    for (const EmbeddedShader& shader : embeddedShaders()) {
        if (shader.path == path) {
            return std::string(shader.source);
        }
    }
    return std::nullopt;
}

namespace {

void appendFile(const std::string& path, const std::string& includedFrom, const SourceLookup& lookup,
                ExpandedSource& out) {
    if (std::find(out.files.begin(), out.files.end(), path) != out.files.end()) {
        return; // each file once
    }
    const auto source = lookup(path);
    if (!source) {
        throw GlError("shader {} not found{}", path,
                      includedFrom.empty() ? "" : " (included from " + includedFrom + ")");
    }
    const std::size_t number = out.files.size();
    out.files.push_back(path);
    out.text += fmt::format("#line 1 {}\n", number);
    int lineNumber = 0;
    for (const std::string& line : split(*source, '\n')) {
        ++lineNumber;
        const auto start = line.find_first_not_of(" \t");
        if (start != std::string::npos && line.compare(start, 8, "#include") == 0) {
            const auto open = line.find('"');
            const auto close = line.rfind('"');
            if (open == std::string::npos || close == open) {
                throw GlError("{}:{}: #include wants a path in double quotes", path, lineNumber);
            }
            appendFile(line.substr(open + 1, close - open - 1), fmt::format("{}:{}", path, lineNumber),
                       lookup, out);
            out.text += fmt::format("#line {} {}\n", lineNumber + 1, number);
        } else {
            out.text += line + "\n";
        }
    }
}

} // namespace

ExpandedSource expandSource(const std::string& path, const Defines& defines, const SourceLookup& lookup) {
    ExpandedSource out;
    out.text = "#version 450 core\n";
    for (const auto& [name, value] : defines) {
        out.text += fmt::format("#define {} {}\n", name, value);
    }
    appendFile(path, "", lookup, out);
    return out;
}

std::vector<std::string> declaredUniforms(std::string_view source) {
    constexpr std::string_view kWord = "uniform";
    const std::string text = withoutComments(source);
    std::vector<std::string> names;
    for (auto at = text.find(kWord); at != text.npos; at = text.find(kWord, at + 1)) {
        const bool isPartOfName =
            (at > 0 && isOfName(text[at - 1])) || isOfName(text.c_str()[at + kWord.size()]);
        const auto end = text.find_first_of(";{[", at);
        if (isPartOfName || end == text.npos || text[end] == '{') {
            continue;
        }
        const auto last = text.find_last_not_of(" \t\r\n", end - 1);
        auto begin = last + 1;
        while (isOfName(text[begin - 1])) {
            --begin;
        }
        names.push_back(text.substr(begin, last + 1 - begin));
    }
    return names;
}

std::string readableLog(const std::string& log, const ExpandedSource& source) {
    // Mesa writes "2:17(5): error", NVIDIA "2(17) : error".
    static const std::regex place(R"((^|\n|ERROR: )(\d+)([:(])(\d+))");
    std::string out;
    auto rest = log.cbegin();
    for (std::sregex_iterator it(log.cbegin(), log.cend(), place), end; it != end; ++it) {
        out.append(rest, (*it)[2].first);
        const auto number = std::size_t(std::stoul((*it)[2].str()));
        out += (number < source.files.size() ? source.files[number] : (*it)[2].str()) + ":" + (*it)[4].str();
        rest = (*it)[4].second;
        if ((*it)[3].str() == "(" && rest != log.cend() && *rest == ')') {
            ++rest;
        }
    }
    out.append(rest, log.cend());
    return out;
}

} // namespace vs::gl
