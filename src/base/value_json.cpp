// SPDX-License-Identifier: Apache-2.0
#include "base/value_json.h"

#include "base/check.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace vs {

namespace {

// A file in the output folder: a plain relative path that stays inside.
std::string readOutputFile(const JsonReader& reader) {
    const std::filesystem::path path = reader.fileName();
    if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
        reader.fail("a file name inside the output folder is wanted");
    }
    if (!path.has_filename() || path.filename() == ".") {
        reader.fail("a file name is wanted, not a folder's");
    }
    if (path.lexically_normal() == "report.json") {
        reader.fail("report.json is what the replay itself writes; choose another name");
    }
    return path.string();
}

// The bounds of a whole number; a rule for one that has none is a mistake in a description.
std::pair<long, long> wholeBounds(const Rule& rule) {
    VS_CHECK(rule.hasBounds());
    return {long(rule.least), long(rule.most)};
}

Json numberSchema(const char* type, const Rule& rule) {
    if (!rule.among.empty()) {
        return {{"enum", std::vector<int>(rule.among.begin(), rule.among.end())}};
    }
    Json schema{{"type", type}};
    if (rule.hasBounds()) {
        const bool isWhole = std::string(type) == "integer";
        schema["minimum"] = isWhole ? Json(std::int64_t(rule.least)) : Json(rule.least);
        schema["maximum"] = isWhole ? Json(std::int64_t(rule.most)) : Json(rule.most);
    }
    if (*rule.unit != '\0') {
        schema["description"] = rule.unit;
    }
    return schema;
}

Json choicesSchema(const Rule& rule) {
    return {{"enum", std::vector<std::string>(rule.choices.begin(), rule.choices.end())}};
}

} // namespace

// --- truth and numbers

void read(const JsonReader& reader, bool& value, const Rule& rule) {
    value = rule.choices.empty() ? reader.boolean() : reader.indexAmong(rule.choices) == 1;
}
Json write(bool value, const Rule& rule) {
    return rule.choices.empty() ? Json(value) : Json(rule.choices[value ? 1 : 0]);
}
Json schemaOf(Type<bool>, const Rule& rule, Json&) {
    return rule.choices.empty() ? Json{{"type", "boolean"}} : choicesSchema(rule);
}

void read(const JsonReader& reader, int& value, const Rule& rule) {
    if (!rule.choices.empty()) {
        value = int(reader.indexAmong(rule.choices));
        return;
    }
    const auto [least, most] = wholeBounds(rule);
    value = int(reader.integerBetween(least, most));
    if (!rule.among.empty() && std::find(rule.among.begin(), rule.among.end(), value) == rule.among.end()) {
        reader.fail(fmt::format("must be {}", fmt::join(rule.among, " or ")));
    }
}
Json write(int value, const Rule& rule) {
    return rule.choices.empty() ? Json(value) : Json(rule.choices[std::size_t(value)]);
}
Json schemaOf(Type<int>, const Rule& rule, Json&) {
    return rule.choices.empty() ? numberSchema("integer", rule) : choicesSchema(rule);
}

void read(const JsonReader& reader, std::uint8_t& value, const Rule& rule) {
    const auto [least, most] = wholeBounds(rule);
    value = std::uint8_t(reader.integerBetween(least, most));
}
Json write(std::uint8_t value, const Rule&) { return int(value); }

void read(const JsonReader& reader, std::uint32_t& value, const Rule& rule) {
    const auto [least, most] = wholeBounds(rule);
    value = std::uint32_t(reader.integerBetween(least, most));
}
Json write(std::uint32_t value, const Rule&) { return value; }
Json schemaOf(Type<std::uint32_t>, const Rule& rule, Json&) { return numberSchema("integer", rule); }

void read(const JsonReader& reader, double& value, const Rule& rule) {
    value = rule.hasBounds() ? reader.numberBetween(rule.least, rule.most) : reader.number();
}
Json write(double value, const Rule&) { return value; }
Json schemaOf(Type<double>, const Rule& rule, Json&) { return numberSchema("number", rule); }

// --- texts

void read(const JsonReader& reader, std::string& value, const Rule& rule) {
    if (!rule.choices.empty()) {
        value = rule.choices[reader.indexAmong(rule.choices)];
        return;
    }
    value = rule.isOutputFile ? readOutputFile(reader) : reader.text();
    if (value.size() < rule.leastCount || value.size() > rule.mostCount) {
        const std::string least =
            rule.leastCount == rule.mostCount ? "" : fmt::format("{} to ", rule.leastCount);
        reader.fail(fmt::format("must be a text of {}{} characters", least, rule.mostCount));
    }
}
Json write(const std::string& value, const Rule&) { return value; }
Json schemaOf(Type<std::string>, const Rule& rule, Json&) {
    if (!rule.choices.empty()) {
        return choicesSchema(rule);
    }
    Json schema{{"type", "string"}};
    if (rule.isOutputFile) {
        schema["minLength"] = 1;
        schema["description"] = "a file inside the output folder";
    }
    if (rule.leastCount > 0) {
        schema["minLength"] = rule.leastCount;
        schema["maxLength"] = rule.mostCount;
    }
    return schema;
}

void read(const JsonReader& reader, std::filesystem::path& value, const Rule&) { value = reader.fileName(); }
Json write(const std::filesystem::path& value, const Rule&) { return value.string(); }
Json schemaOf(Type<std::filesystem::path>, const Rule&, Json&) {
    return {{"type", "string"}, {"minLength", 1}};
}

// --- lists

void expectCount(const JsonReader& reader, const Rule& rule) {
    const std::size_t count = reader.size();
    const bool isWrong = count < rule.leastCount || count > rule.mostCount;
    if (isWrong && *rule.wrongCount != '\0') {
        reader.fail(fmt::format(fmt::runtime(rule.wrongCount), count, rule.leastCount, rule.mostCount));
    }
    if (count < rule.leastCount) {
        reader.fail(fmt::format("must have at least {} {}", rule.leastCount,
                                rule.leastCount == 1 ? "entry" : "entries"));
    }
    if (count > rule.mostCount) {
        reader.fail(fmt::format("must have at most {} entries", rule.mostCount));
    }
}
Json listSchema(Json items, const Rule& rule) {
    Json schema{{"type", "array"}, {"items", std::move(items)}};
    if (rule.leastCount > 0) {
        schema["minItems"] = rule.leastCount;
    }
    if (rule.mostCount != Rule().mostCount) {
        schema["maxItems"] = rule.mostCount;
    }
    return schema;
}

// --- ranges

void read(const JsonReader& reader, Range& value, const Rule& rule) {
    reader.expectSize(2);
    read(reader.at(0), value.lo, rule);
    read(reader.at(1), value.hi, rule);
    if (value.lo > value.hi) {
        reader.fail("its first number must not be above its second");
    }
}
Json write(const Range& value, const Rule&) { return Json::array({value.lo, value.hi}); }
Json schemaOf(Type<Range>, const Rule& rule, Json& definitions) {
    Json schema = listSchema(schemaOf(Type<double>(), rule, definitions), {.leastCount = 2, .mostCount = 2});
    if (rule.hasBounds()) {
        return schema;
    }
    definitions["range"] = std::move(schema);
    return {{"$ref", "#/$defs/range"}};
}

// --- the version of a file

void expectVersion(const JsonReader& file, const FileFormat& format) {
    const JsonReader version = file.member(format.member);
    if (version.integerBetween(1, 1 << 20) > format.version) {
        version.fail(fmt::format("made by a newer Volume Studio (this program knows version {}); update it",
                                 format.version));
    }
}

} // namespace vs
