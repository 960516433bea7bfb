// SPDX-License-Identifier: Apache-2.0
#include "render/colours/transfer_function_json.h"

#include "base/described_json.h"
#include "render/colours/function_values.h"

namespace vs::render {

Json toJson(const TransferFunction& function) { return writeDescribed(function, Rule()); }

TransferFunction transferFunctionFromJson(const Json& json, const std::string& where) {
    TransferFunction function;
    readDescribed(JsonReader(json, where), function, Rule());
    return function;
}

} // namespace vs::render
