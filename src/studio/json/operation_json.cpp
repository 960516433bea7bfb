// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json.h"

#include "studio/json/described_json.h"

namespace vs::studio {

Json toJson(const Operation& operation) { return write(operation, {}); }

Operation operationFromJson(const Json& json, const std::string& where) {
    Operation operation;
    read(JsonReader(json, where), operation, {});
    return operation;
}

} // namespace vs::studio
