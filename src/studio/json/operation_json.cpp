// SPDX-License-Identifier: Apache-2.0
#include "studio/json/operation_json.h"

#include "base/described_json.h"
#include "studio/json/value_json.h"

#include <type_traits>

namespace vs::studio {

namespace {

template <Described T>
bool hasReferenceTo(std::string_view name, const T& value) {
    bool isThere = false;
    forEachField(T::fields(), [&]<typename F>(const F& field) {
        using Value = ValueOf<const T, F>;
        const auto& member = valueOf(value, field.access);
        if constexpr (F::kPresence == Presence::Spread) {
            isThere = isThere || hasReferenceTo(name, member);
        } else if constexpr (std::is_same_v<Value, std::string>) {
            isThere = isThere || (field.rule.isReference && member == name);
        }
    });
    return isThere;
}

} // namespace

bool speaksOf(const Operation& operation, std::string_view segment) {
    return std::visit([&](const auto& one) { return hasReferenceTo(segment, one); }, operation);
}

Json toJson(const Operation& operation) { return write(operation, Rule()); }

Operation operationFromJson(const Json& json, const std::string& where) {
    Operation operation;
    read(JsonReader(json, where), operation, Rule());
    return operation;
}

} // namespace vs::studio
