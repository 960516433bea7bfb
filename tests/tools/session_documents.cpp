// SPDX-License-Identifier: Apache-2.0
// Compares what doc/ says of session files and transfer functions with what their descriptions say: the
// schemas, and the tables of doc/session.md and doc/transfer_functions.md.
//
// usage: session_documents ROOT [--fix]
// ROOT: of the repository; with --fix the documents are brought up to date.
#include "function_schema.h"
#include "session_schema.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

constexpr const char* kBegin = "<!-- made by session_documents: begin -->\n";
constexpr const char* kEnd = "<!-- made by session_documents: end -->\n";

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The document with what lies between the marks replaced; empty when it has none.
std::string withTables(const std::string& document, const std::string& tables) {
    const std::size_t begin = document.find(kBegin);
    const std::size_t end = document.find(kEnd);
    if (begin == std::string::npos || end == std::string::npos) {
        return {};
    }
    return document.substr(0, begin) + kBegin + tables + document.substr(end);
}

// Whether the document is as it should be, now.
bool settle(const std::filesystem::path& path, const std::string& wanted, bool isToFix) {
    if (wanted.empty()) {
        std::fprintf(stderr, "%s: the marks '%.*s' are missing\n", path.c_str(), 33, kBegin);
        return false;
    }
    if (textOf(path) == wanted) {
        return true;
    }
    if (isToFix) {
        std::ofstream(path) << wanted;
        return true;
    }
    std::fprintf(stderr, "%s is not what the descriptions say; run session_documents ROOT --fix\n",
                 path.c_str());
    return false;
}

} // namespace

int main(int argc, char** argv) {
    const bool isToFix = argc == 3 && std::string_view(argv[2]) == "--fix";
    if (argc != 2 && !isToFix) {
        std::fprintf(stderr, "usage: session_documents ROOT [--fix]\n");
        return 2;
    }
    const std::filesystem::path doc = std::filesystem::path(argv[1]) / "doc";
    const auto settleBoth = [&](const char* schemaFile, const vs::Json& schema, const char* pageFile,
                                const std::string& tables) {
        const bool isSchemaRight = settle(doc / schemaFile, schema.dump(1) + "\n", isToFix);
        return settle(doc / pageFile, withTables(textOf(doc / pageFile), tables), isToFix) && isSchemaRight;
    };
    const bool isSessionRight = settleBoth("session.schema.json", vs::studio::sessionSchema(), "session.md",
                                           vs::studio::operationTables());
    const bool isFunctionRight = settleBoth("transfer_function.schema.json", vs::render::functionSchema(),
                                            "transfer_functions.md", vs::render::functionTable());
    return isSessionRight && isFunctionRight ? 0 : 1;
}
