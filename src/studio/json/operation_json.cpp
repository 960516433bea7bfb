// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json.h"

#include "base/described_json.h"
#include "studio/json/value_json.h"

namespace vs::studio {

Json toJson(const Operation& operation) { return write(operation, Rule()); }

Operation operationFromJson(const Json& json, const std::string& where) {
    Operation operation;
    read(JsonReader(json, where), operation, Rule());
    return operation;
}

} // namespace vs::studio
