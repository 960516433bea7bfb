// SPDX-License-Identifier: Apache-2.0
#include "session_schema.h"

#include "function_schema.h"
#include "member_table.h"
#include "phantom/recipe.h"
#include "studio/json/value_json.h"

#include <fmt/format.h>

namespace vs::studio {

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

// A file, a phantom, or a block made from nothing.
Json volumeSchema(Json& definitions) {
    const Json text{{"type", "string"}};
    const Json file = object({{"path", {{"type", "string"}, {"minLength", 1}}},
                              {"checksum", text},
                              {"raw", text},
                              {"series", text},
                              {"frame", {{"type", "integer"}, {"minimum", 0}}},
                              {"level", {{"type", "integer"}, {"minimum", 0}}},
                              {"channel", {{"type", "integer"}, {"minimum", 0}}}},
                             Json::array({"path"}));
    Json dims = coordinates({{"type", "integer"}, {"minimum", 1}, {"maximum", 1024}});
    dims["description"] = "voxels of a volume made from nothing";
    Json spacing = coordinates({{"type", "number"}, {"minimum", 0.001}, {"maximum", 1000}});
    spacing["description"] = "mm";
    const Json block =
        object({{"block", std::move(dims)}, {"spacing", std::move(spacing)}, {"checksum", text}},
               Json::array({"block"}));
    Json phantom = describedSchema<phantom::Recipe>(Rule(), definitions);
    phantom["properties"]["checksum"] = text;
    return {{"oneOf", Json::array({file, block, phantom})}};
}

// --- the table of operations

template <typename T>
void addOperation(std::string& table, MemberTable& members) {
    std::vector<const char*> names;
    addNames<T>(T::fields(), names, [](const auto&) { return true; });
    std::string all;
    for (const char* name : names) {
        all += std::string(all.empty() ? "" : ", ") + "`" + name + "`";
    }
    table += fmt::format("| `{}` | {} | {} |\n", T::kAbout.name, all, T::kAbout.meaning);
    members.add<T>(T::kAbout.name);
}

template <typename... Ops>
void addOperations(Type<std::variant<Ops...>>, std::string& table, MemberTable& members) {
    (addOperation<Ops>(table, members), ...);
}

} // namespace

Json sessionSchema() {
    Json definitions = Json::object();
    const Json operations = schemaOf(Type<Operation>(), Rule(), definitions);
    Json schema = object({{"volumeStudioSession", {{"const", 1}}},
                          {"volume", volumeSchema(definitions)},
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
    MemberTable members;
    addOperations(Type<Operation>(), table, members);
    members.add<Sketch>("a sketch");
    members.add<Trail>("a trail");
    members.add<SweepPath>("a path");
    members.add<Clip::Plane>("a plane");
    members.add<render::Camera>("a camera");
    members.add<render::Placement>("a placement");
    members.add<Canvas>("a canvas");
    return table + "\n" + members.markdown();
}

} // namespace vs::studio
