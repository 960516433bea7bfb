// SPDX-License-Identifier: Apache-2.0
#include "member_table.h"

#include <fmt/ranges.h>

namespace vs {

namespace {

// How many elements a list may have.
std::string countInWords(const Json& schema) {
    const bool hasLeast = schema.contains("minItems");
    const bool hasMost = schema.contains("maxItems");
    const int least = schema.value("minItems", 0);
    const int most = schema.value("maxItems", 0);
    return hasLeast && least == most ? fmt::format("{} of: ", least)
           : hasLeast && hasMost     ? fmt::format("{} to {} of: ", least, most)
           : hasLeast                ? fmt::format("{} or more of: ", least)
           : hasMost                 ? fmt::format("at most {} of: ", most)
                                     : "a list of: ";
}

} // namespace

std::string inWords(const Json& schema) {
    const auto code = [](const Json& one) {
        return "`" + (one.is_string() ? one.get<std::string>() : one.dump()) + "`";
    };
    if (schema.contains("$ref")) {
        const auto name = schema["$ref"].get<std::string>();
        std::string words = "a " + name.substr(name.rfind('/') + 1);
        std::replace(words.begin(), words.end(), '-', ' ');
        return words;
    }
    if (schema.contains("oneOf")) {
        std::vector<std::string> all;
        for (const Json& one : schema["oneOf"]) {
            all.push_back(inWords(one));
        }
        return fmt::format("{}", fmt::join(all, " or "));
    }
    if (schema.contains("enum")) {
        std::vector<std::string> all;
        for (const Json& one : schema["enum"]) {
            all.push_back(code(one));
        }
        return fmt::format("{}", fmt::join(all, ", "));
    }
    const Json type = schema.value("type", Json());
    if (type == "array") {
        return schema.contains("prefixItems") ? "a list of numbers"
                                              : countInWords(schema) + inWords(schema["items"]);
    }
    if (schema.contains("minimum")) {
        return fmt::format("{}{:.10g} to {:.10g}", type == "integer" ? "whole, " : "",
                           schema["minimum"].get<double>(), schema["maximum"].get<double>());
    }
    return type == "boolean" ? "`true`, `false`"
           : type == "null"  ? "`null`"
           : schema.contains("maxLength")
               ? fmt::format("a text of {} to {} characters", schema["minLength"].dump(),
                             schema["maxLength"].dump())
               : "a " + (type == "string" ? std::string("text") : type.get<std::string>());
}

void MemberTable::addRow(const Row& row, const std::string& owner) {
    const auto same =
        std::find_if(rows_.begin(), rows_.end(), [&](const auto& known) { return known.first == row; });
    (same != rows_.end() ? *same : rows_.emplace_back(row, std::vector<std::string>()))
        .second.push_back(owner);
}

std::string MemberTable::markdown() const {
    std::string table = "| member | of | value | default | |\n|---|---|---|---|---|\n";
    for (const auto& [row, owners] : rows_) {
        table += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.name, fmt::join(owners, ", "), row.value,
                             row.byDefault, row.meaning);
    }
    return table;
}

} // namespace vs
