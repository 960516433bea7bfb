// SPDX-License-Identifier: Apache-2.0
#include "function_schema.h"

#include "member_table.h"
#include "render/colours/function_values.h"
#include "studio/json/value_json.h"

namespace vs {

Json schemaOf(Type<render::TransferFunction>, const Rule& rule, Json& definitions) {
    const std::string name = definitionName<render::TransferFunction>(rule);
    if (!definitions.contains(name)) {
        definitions[name] = describedSchema<render::TransferFunction>(rule, definitions);
    }
    return {{"oneOf", Json::array({{{"description", "a preset's name"}, {"type", "string"}},
                                   {{"$ref", "#/$defs/" + name}}})}};
}

} // namespace vs

namespace vs::render {

Json functionSchema() {
    Json definitions = Json::object();
    const Json function = describedSchema<TransferFunction>(Rule(), definitions);
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", fmt::format("Volume Studio transfer function, version {}",
                                      TransferFunction::kFormat.version)}};
    schema.update(function);
    schema["$defs"] = std::move(definitions);
    return schema;
}

std::string functionTable() {
    MemberTable members;
    members.add<TransferFunction>("a function");
    members.add<ControlPoint>("a control point");
    members.add<SpreadColours>("a colour map");
    members.add<ShapeInFiles>("a shape");
    return members.markdown();
}

} // namespace vs::render
