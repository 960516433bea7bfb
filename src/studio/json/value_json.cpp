// SPDX-License-Identifier: Apache-2.0
#include "studio/json/value_json.h"

#include "base/check.h"
#include "render/colours/transfer_function_json.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace vs::studio {

namespace {

constexpr double kMostTilt = 60; // degrees
constexpr Rule kPressure{.least = 0, .most = 1};
constexpr Rule kTilt{.least = -kMostTilt, .most = kMostTilt, .unit = "degrees"};

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
    value = rule.isOutputFile ? readOutputFile(reader) : reader.text();
    if (value.size() < rule.leastCount || value.size() > rule.mostCount) {
        reader.fail(fmt::format("must be a text of {} to {} characters", rule.leastCount, rule.mostCount));
    }
}
Json write(const std::string& value, const Rule&) { return value; }
Json schemaOf(Type<std::string>, const Rule& rule, Json&) {
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
    if (reader.size() < rule.leastCount) {
        reader.fail(fmt::format("must have at least {} {}", rule.leastCount,
                                rule.leastCount == 1 ? "entry" : "entries"));
    }
    if (reader.size() > rule.mostCount) {
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

// --- what is written as a list, or by a name

void read(const JsonReader& reader, Range& value, const Rule&) {
    value = {reader.at(0).number(), reader.at(1).number()};
    reader.expectSize(2);
    if (value.lo > value.hi) {
        reader.fail("its first number must not be above its second");
    }
}
Json write(const Range& value, const Rule&) { return Json::array({value.lo, value.hi}); }
Json schemaOf(Type<Range>, const Rule&, Json& definitions) {
    definitions["range"] = {
        {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
    return {{"$ref", "#/$defs/range"}};
}

void read(const JsonReader& reader, Clip::Box& value, const Rule& rule) {
    if (reader.size() != 2) {
        reader.fail("must be a list of two places, the lower and the upper corner, in voxels");
    }
    read(reader.at(0), value.lo, rule);
    read(reader.at(1), value.hi, rule);
}
Json write(const Clip::Box& value, const Rule& rule) {
    return Json::array({write(value.lo, rule), write(value.hi, rule)});
}
Json schemaOf(Type<Clip::Box>, const Rule& rule, Json& definitions) {
    return listSchema(schemaOf(Type<glm::dvec3>(), rule, definitions), {.leastCount = 2, .mostCount = 2});
}

void read(const JsonReader& reader, sculpt::PenPoint& value, const Rule&) {
    if (reader.size() != 3 && reader.size() != 5) {
        reader.fail("must be a list of 3 numbers, x, y and pressure, or of 5 with the pen's tilt in x and y");
    }
    for (int i = 0; i < 2; ++i) {
        read(reader.at(std::size_t(i)), value.pixel[i], kPixels);
    }
    read(reader.at(2), value.pressure, kPressure);
    for (int i = 0; i < 2 && reader.size() == 5; ++i) {
        read(reader.at(std::size_t(3 + i)), value.tiltDegrees[i], kTilt);
    }
}
Json write(const sculpt::PenPoint& value, const Rule&) {
    Json point = Json::array({value.pixel.x, value.pixel.y, value.pressure});
    if (value.tiltDegrees != glm::dvec2(0)) {
        point.push_back(value.tiltDegrees.x);
        point.push_back(value.tiltDegrees.y);
    }
    return point;
}
Json schemaOf(Type<sculpt::PenPoint>, const Rule&, Json& definitions) {
    const auto of = [&](const Rule& rule) { return schemaOf(Type<double>(), rule, definitions); };
    return {
        {"description", "x, y, pressure and, if known, the pen's tilt to the right and towards the person"},
        {"type", "array"},
        {"prefixItems", Json::array({of(kPixels), of(kPixels), of(kPressure), of(kTilt), of(kTilt)})},
        {"minItems", 3},
        {"maxItems", 5}};
}

void read(const JsonReader& reader, render::TransferFunction& value, const Rule&) {
    if (!reader.isText()) {
        value = render::transferFunctionFromJson(reader.json(), reader.place());
        return;
    }
    const auto preset = render::findPreset(reader.text());
    if (!preset) {
        reader.fail(fmt::format("there is no preset of that name; there are {}",
                                fmt::join(render::presetNames(), ", ")));
    }
    value = *preset;
}
Json write(const render::TransferFunction& value, const Rule&) {
    for (const std::string& name : render::presetNames()) {
        if (render::findPreset(name) == value) {
            return name;
        }
    }
    return render::toJson(value);
}
Json schemaOf(Type<render::TransferFunction>, const Rule&, Json&) {
    return {{"description", "a preset's name, or a whole function (doc/transfer_function.schema.json)"},
            {"type", Json::array({"string", "object"})}};
}

void read(const JsonReader& reader, render::Background& value, const Rule&) {
    try {
        value = render::backgroundFromName(reader.text());
    } catch (const UsageError& error) {
        reader.fail(error.what());
    }
}
Json write(const render::Background& value, const Rule&) { return render::name(value); }
Json schemaOf(Type<render::Background>, const Rule&, Json&) {
    return {{"type", "string"},
            {"pattern", "^(studio|white|black|transparent|#[0-9A-Fa-f]{6}(:#[0-9A-Fa-f]{6})?)$"}};
}

} // namespace vs::studio
