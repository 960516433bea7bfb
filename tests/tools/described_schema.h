// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/described_json.h"

#include <algorithm>

namespace vs {

// The schema (JSON Schema draft 2020-12) of everything that has a description (base/description.h).

template <Described T>
Json schemaOf(Type<T>, const Rule& rule, Json& definitions);

template <StandsAsAnother T>
Json schemaOf(Type<T>, const Rule& rule, Json& definitions) {
    return schemaOf(Type<typename T::InFiles>(), rule, definitions);
}

template <typename... Ops>
Json schemaOf(Type<std::variant<Ops...>>, const Rule& rule, Json& definitions) {
    return {{"oneOf", Json::array({schemaOf(Type<Ops>(), rule, definitions)...})}};
}

// What a described struct is called in definitions: "control-point-without-colour".
template <typename T>
std::string definitionName(const Rule& rule) {
    std::string name;
    if constexpr (isOperation<T>) {
        name = T::kAbout.name;
    } else {
        name = T::kName;
    }
    if (*rule.without != '\0') {
        name += std::string(" without ") + rule.without;
    }
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

// --- the variants of a struct, whose fields depend on what others are

template <typename T>
std::vector<T> possibleValues(Type<T>) {
    return {T{}};
}
template <Named E>
std::vector<E> possibleValues(Type<E>) {
    std::vector<E> values;
    for (std::size_t i = 0; i < namesOf(E()).size(); ++i) {
        values.push_back(E(i));
    }
    return values;
}
template <typename T>
std::vector<std::optional<T>> possibleValues(Type<std::optional<T>>) {
    return {std::nullopt, T{}};
}

// One object for each combination of what the deciding fields can be; one if there are none.
template <typename T>
std::vector<T> variantsOf() {
    std::vector<T> variants{T{}};
    forEachField(T::fields(), [&]<typename F>(const F& field) {
        if (!field.decides) {
            return;
        }
        std::vector<T> more;
        for (const T& variant : variants) {
            if (!field.applies(variant)) {
                more.push_back(variant);
                continue;
            }
            for (const auto& value : possibleValues(Type<ValueOf<T, F>>())) {
                more.push_back(variant);
                valueOf(more.back(), field.access) = value;
            }
        }
        variants = std::move(more);
    });
    return variants;
}

// Whether a field means something in a variant: a condition on other fields only says when it is written.
template <typename T, typename F>
bool isIn(const T& variant, const F& field) {
    return (F::kPresence != Presence::Required && !field.isRefusedElsewhere) || field.applies(variant);
}

// --- the schema of one variant

inline void addMeaning(Json& schema, const char* meaning) {
    if (*meaning != '\0') {
        const std::string unit = schema.value("description", "");
        schema["description"] = unit.empty() ? meaning : unit + "; " + meaning;
    }
}

template <typename T, typename F>
void addDeciding(Json& schema, const T& value, const F& field, const Rule&, Json& definitions) {
    const auto& member = valueOf(value, field.access);
    if constexpr (Named<ValueOf<T, F>>) {
        schema["properties"][field.name] = {{"enum", {nameOf(member)}}};
        schema["required"].push_back(field.name);
    } else if constexpr (isOptional<ValueOf<T, F>>) {
        if (member) {
            schema["properties"][field.name] = schemaOf(Type<ValueOf<T, F>>(), field.rule, definitions);
            schema["required"].push_back(field.name);
        }
    }
}

// Into an object's schema: the fields that mean something in `value`.
template <typename T, typename Fields>
void addFields(Json& schema, const T& value, const Fields& fields, const Rule& rule, Json& definitions) {
    forEachField(fields, [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Group) {
            Json inner{{"type", "object"}, {"properties", Json::object()}};
            addFields(inner, value, field.inner, rule, definitions);
            inner["additionalProperties"] = false;
            schema["properties"][field.name] = std::move(inner);
        } else if constexpr (F::kPresence == Presence::Spread) {
            addFields(schema, valueOf(value, field.access), ValueOf<T, F>::fields(), {}, definitions);
        } else if (!isIn(value, field) || isLeftOut(field, rule)) {
            return;
        } else if (field.decides) {
            addDeciding(schema, value, field, rule, definitions);
        } else {
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
Json objectSchema(const T& value, const Rule& rule, Json& definitions) {
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    if constexpr (isOperation<T>) {
        schema["description"] = T::kAbout.meaning;
        schema["properties"]["op"] = {{"const", T::kAbout.name}};
        schema["required"].push_back("op");
    }
    if constexpr (isFile<T>) {
        schema["properties"][T::kFormat.member] = {{"const", T::kFormat.version}};
        schema["required"].push_back(T::kFormat.member);
    }
    addFields(schema, value, T::fields(), rule, definitions);
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

// --- all variants

// The name of the first field that decides by its name; "" where there is none.
template <typename T>
std::string decidingName() {
    std::string name;
    forEachField(T::fields(), [&]<typename F>(const F& field) {
        if (field.decides && name.empty()) {
            name = field.name;
        }
    });
    return name;
}

// Takes a variant's schema in with one that only has another name, if there is one.
inline void addVariant(Json& variants, Json variant, const std::string& kind) {
    Json& names = variant["properties"][kind]["enum"];
    for (Json& known : variants) {
        Json& knownNames = known["properties"][kind]["enum"];
        const Json before = std::exchange(knownNames, names);
        const bool isSame = known == variant;
        knownNames = before;
        if (isSame) {
            knownNames.push_back(names[0]);
            return;
        }
    }
    variants.push_back(std::move(variant));
}

template <Described T>
Json describedSchema(const Rule& rule, Json& definitions) {
    const std::string kind = decidingName<T>();
    if (kind.empty()) {
        return objectSchema(T{}, rule, definitions);
    }
    Json variants = Json::array();
    for (const T& value : variantsOf<T>()) {
        addVariant(variants, objectSchema(value, rule, definitions), kind);
    }
    return {{"oneOf", std::move(variants)}};
}

template <Described T>
Json schemaOf(Type<T>, const Rule& rule, Json& definitions) {
    const std::string name = definitionName<T>(rule);
    if (!definitions.contains(name)) {
        definitions[name] = describedSchema<T>(rule, definitions);
    }
    return {{"$ref", "#/$defs/" + name}};
}

} // namespace vs
