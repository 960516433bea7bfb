// SPDX-License-Identifier: Apache-2.0
#include "session_schema.h"

#include "studio/json/described_json.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace vs::studio {

namespace {

// --- the schema of what has a description

template <typename T>
std::string definitionName() {
    std::string name;
    if constexpr (isOperation<T>) {
        name = T::kAbout.name;
        std::replace(name.begin(), name.end(), ' ', '-');
    } else {
        name = Description<T>::name();
    }
    return name;
}

} // namespace

template <Described T>
Json schemaOf(Type<T>, const Rule& rule, Json& definitions);

template <typename... Ops>
Json schemaOf(Type<std::variant<Ops...>>, const Rule& rule, Json& definitions) {
    return {{"oneOf", Json::array({schemaOf(Type<Ops>(), rule, definitions)...})}};
}

namespace {

void addMeaning(Json& schema, const char* meaning) {
    if (*meaning != '\0') {
        const std::string unit =
            schema.contains("description") ? schema["description"].get<std::string>() : "";
        schema["description"] = unit.empty() ? meaning : unit + "; " + meaning;
    }
}

// Into an object's schema: the fields that mean something in `value`.
template <typename T, typename Fields>
void addFields(Json& schema, const T& value, const Fields& fields, Json& definitions) {
    forEachField(fields, [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Group) {
            Json inner{{"type", "object"}, {"properties", Json::object()}};
            addFields(inner, value, field.inner, definitions);
            inner["additionalProperties"] = false;
            schema["properties"][field.name] = std::move(inner);
        } else if constexpr (F::kPresence == Presence::Spread) {
            addFields(schema, valueOf(value, field.access), Description<ValueOf<T, F>>::fields(),
                      definitions);
        } else {
            if (F::kPresence == Presence::Required && !field.applies(value)) {
                return;
            }
            Json member = schemaOf(Type<ValueOf<T, F>>(), field.rule, definitions);
            addMeaning(member, field.meaning);
            schema["properties"][field.name] = std::move(member);
            if (F::kPresence == Presence::Required) {
                schema["required"].push_back(field.name);
            }
        }
    });
}

template <typename T>
Json objectSchema(const T& value, Json& definitions) {
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    if constexpr (isOperation<T>) {
        schema["description"] = T::kAbout.meaning;
        schema["properties"]["op"] = {{"const", T::kAbout.name}};
        schema["required"].push_back("op");
    }
    addFields(schema, value, Description<T>::fields(), definitions);
    schema["additionalProperties"] = false;
    if constexpr (requires { T::kNeedsOneOf; }) {
        for (const char* name : T::kNeedsOneOf) {
            Json given{{"required", Json::array({name})}};
            if (schema["properties"][name].value("type", "") == "array") {
                given["properties"][name] = {{"minItems", 1}};
            }
            schema["anyOf"].push_back(std::move(given));
        }
    }
    return schema;
}

template <typename T>
constexpr bool hasVariants() {
    bool has = false;
    forEachField(Description<T>::fields(), [&]<typename F>(const F& field) {
        has = has || (F::kPresence == Presence::Required &&
                      !std::is_same_v<std::remove_cvref_t<decltype(field.applies)>, Always>);
    });
    return has;
}

// Where fields depend on a kind, which is then the first of them: one schema for each kind.
template <typename T>
Json variantsSchema(Json& definitions) {
    const auto fields = Description<T>::fields();
    const auto& first = std::get<0>(fields);
    using Kind = ValueOf<T, std::remove_cvref_t<decltype(first)>>;
    Json variants = Json::array();
    for (std::size_t i = 0; i < namesOf(Kind()).size(); ++i) {
        T value{};
        valueOf(value, first.access) = Kind(i);
        Json schema = objectSchema(value, definitions);
        schema["properties"][first.name] = {{"const", nameOf(Kind(i))}};
        variants.push_back(std::move(schema));
    }
    return {{"oneOf", std::move(variants)}};
}

} // namespace

template <Described T>
Json schemaOf(Type<T>, const Rule&, Json& definitions) {
    const std::string name = definitionName<T>();
    if (!definitions.contains(name)) {
        Json schema;
        if constexpr (hasVariants<T>()) {
            schema = variantsSchema<T>(definitions);
        } else {
            schema = objectSchema(T{}, definitions);
        }
        definitions[name] = std::move(schema);
    }
    return {{"$ref", "#/$defs/" + name}};
}

namespace {

Json coordinates(Json number) {
    return {{"type", "array"}, {"items", std::move(number)}, {"minItems", 3}, {"maxItems", 3}};
}

Json object(Json properties, Json required) {
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

// A file, or a block made from nothing.
Json volumeSchema() {
    const Json text{{"type", "string"}};
    const Json file = object({{"path", {{"type", "string"}, {"minLength", 1}}},
                              {"checksum", text},
                              {"raw", text},
                              {"series", text},
                              {"frame", {{"type", "integer"}, {"minimum", 0}}}},
                             Json::array({"path"}));
    Json dims = coordinates({{"type", "integer"}, {"minimum", 1}, {"maximum", 1024}});
    dims["description"] = "voxels of a volume made from nothing";
    Json spacing = coordinates({{"type", "number"}, {"minimum", 0.001}, {"maximum", 1000}});
    spacing["description"] = "mm";
    const Json block =
        object({{"block", std::move(dims)}, {"spacing", std::move(spacing)}, {"checksum", text}},
               Json::array({"block"}));
    return {{"oneOf", Json::array({file, block})}};
}

// --- the tables

struct Member {
    std::string name;
    std::string value;
    std::string byDefault;
    std::string meaning;

    auto operator<=>(const Member&) const = default;
};

// What a value may be, in words, by its schema.
std::string inWords(const Json& schema) {
    const auto code = [](const Json& one) {
        return "`" + (one.is_string() ? one.get<std::string>() : one.dump()) + "`";
    };
    if (schema.contains("$ref")) {
        const auto name = schema["$ref"].get<std::string>();
        return "a " + name.substr(name.rfind('/') + 1);
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
        const bool isFixed = schema.contains("minItems") && schema.value("maxItems", 0) == schema["minItems"];
        const Json items = schema.value("items", Json{{"type", "array"}});
        const std::string count =
            isFixed ? std::to_string(schema["minItems"].get<int>()) + " of: " : "a list of: ";
        return schema.contains("prefixItems") ? "a list of numbers" : count + inWords(items);
    }
    if (schema.contains("minimum")) {
        return fmt::format("{}{:.10g} to {:.10g}", type == "integer" ? "whole, " : "",
                           schema["minimum"].get<double>(), schema["maximum"].get<double>());
    }
    return type == "boolean" ? "`true`, `false`"
           : type == "null"  ? "`null`"
           : type.is_array() ? "a text or an object"
           : schema.contains("maxLength")
               ? fmt::format("a text of {} to {} characters", schema["minLength"].dump(),
                             schema["maxLength"].dump())
               : "a " + (type == "string" ? std::string("text") : type.get<std::string>());
}

template <typename T, typename Fields, typename Add>
void listMembers(const Fields& fields, const std::string& prefix, Add add) {
    forEachField(fields, [&]<typename F>(const F& field) {
        const T byDefault{};
        if constexpr (F::kPresence == Presence::Group) {
            listMembers<T>(field.inner, std::string(field.name) + ".", add);
        } else if constexpr (F::kPresence == Presence::Spread) {
            listMembers<ValueOf<T, F>>(Description<ValueOf<T, F>>::fields(), prefix, add);
        } else {
            Json ignored = Json::object();
            const Json value = write(valueOf(byDefault, field.access), field.rule);
            const bool hasDefault =
                F::kPresence != Presence::Required && value.is_primitive() && !value.is_null() && value != "";
            std::string text = inWords(schemaOf(Type<ValueOf<T, F>>(), field.rule, ignored));
            if (*field.rule.unit != '\0') {
                text += std::string(", ") + field.rule.unit;
            }
            add(Member{prefix + field.name, text,
                       F::kPresence == Presence::Required ? "needed"
                       : hasDefault                       ? "`" + value.dump() + "`"
                                                          : "",
                       field.meaning});
        }
    });
}

using MembersAndOwners = std::vector<std::pair<Member, std::vector<std::string>>>;

template <typename T>
void listDescribed(const std::string& owner, MembersAndOwners& members) {
    listMembers<T>(Description<T>::fields(), "", [&](const Member& member) {
        const auto same = std::find_if(members.begin(), members.end(),
                                       [&](const auto& known) { return known.first == member; });
        (same != members.end() ? *same : members.emplace_back(member, std::vector<std::string>()))
            .second.push_back(owner);
    });
}

template <typename T>
void addOperation(std::string& table, MembersAndOwners& members) {
    std::vector<const char*> names;
    addNames<T>(Description<T>::fields(), names);
    std::string all;
    for (const char* name : names) {
        all += std::string(all.empty() ? "" : ", ") + "`" + name + "`";
    }
    table += fmt::format("| `{}` | {} | {} |\n", T::kAbout.name, all, T::kAbout.meaning);
    listDescribed<T>(T::kAbout.name, members);
}

template <typename... Ops>
void addOperations(Type<std::variant<Ops...>>, std::string& table, MembersAndOwners& members) {
    (addOperation<Ops>(table, members), ...);
}

} // namespace

Json sessionSchema() {
    Json definitions = Json::object();
    const Json operations = schemaOf(Type<Operation>(), Rule(), definitions);
    Json schema = object({{"volumeStudioSession", {{"const", 1}}},
                          {"volume", volumeSchema()},
                          {"precision",
                           {{"description", "bits of the sculpture's values: 8, or 16- or 32-bit floats"},
                            {"enum", {8, 16, 32}}}},
                          {"operations", {{"type", "array"}, {"items", operations}}}},
                         Json::array({"volumeStudioSession", "volume", "operations"}));
    Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
               {"title", "Volume Studio session, version 1"}};
    whole.update(schema);
    whole["$defs"] = std::move(definitions);
    return whole;
}

std::string operationTables() {
    std::string table = "| op | members | what it does |\n|---|---|---|\n";
    MembersAndOwners members;
    addOperations(Type<Operation>(), table, members);
    listDescribed<Sketch>("a sketch", members);
    listDescribed<Trail>("a trail", members);
    listDescribed<SweepPath>("a path", members);
    listDescribed<Clip::Plane>("a plane", members);
    listDescribed<render::Camera>("a camera", members);
    listDescribed<render::Placement>("a placement", members);
    listDescribed<Canvas>("a canvas", members);
    table += "\n| member | of | value | default | |\n|---|---|---|---|---|\n";
    for (const auto& [member, owners] : members) {
        table += fmt::format("| `{}` | {} | {} | {} | {} |\n", member.name, fmt::join(owners, ", "),
                             member.value, member.byDefault, member.meaning);
    }
    return table;
}

} // namespace vs::studio
