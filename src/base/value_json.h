// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"
#include "base/json_reader.h"
#include "base/math.h"
#include "base/names.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vs {

// The values that described structs are made of, in files: how each type is read by a rule, written, and
// described in a schema. A module that has further such types adds overloads in this namespace, where all of
// them are found. read() throws SessionError with the place where it reads.

using Json = nlohmann::ordered_json;

// Stands for a type where there is no value of it.
template <typename T>
struct Type {};

void read(const JsonReader& reader, bool& value, const Rule& rule);
void read(const JsonReader& reader, int& value, const Rule& rule);
void read(const JsonReader& reader, std::uint8_t& value, const Rule& rule);
void read(const JsonReader& reader, std::uint32_t& value, const Rule& rule);
void read(const JsonReader& reader, double& value, const Rule& rule);
void read(const JsonReader& reader, std::string& value, const Rule& rule);
void read(const JsonReader& reader, std::filesystem::path& value, const Rule& rule);
void read(const JsonReader& reader, Range& value, const Rule& rule);

Json write(bool value, const Rule& rule);
Json write(int value, const Rule& rule);
Json write(std::uint8_t value, const Rule& rule);
Json write(std::uint32_t value, const Rule& rule);
Json write(double value, const Rule& rule);
Json write(const std::string& value, const Rule& rule);
Json write(const std::filesystem::path& value, const Rule& rule);
Json write(const Range& value, const Rule& rule);

// The schema of a type under a rule. Described structs are put into `definitions` under their names.
Json schemaOf(Type<bool>, const Rule& rule, Json& definitions);
Json schemaOf(Type<int>, const Rule& rule, Json& definitions);
Json schemaOf(Type<std::uint32_t>, const Rule& rule, Json& definitions);
Json schemaOf(Type<double>, const Rule& rule, Json& definitions);
Json schemaOf(Type<std::string>, const Rule& rule, Json& definitions);
Json schemaOf(Type<std::filesystem::path>, const Rule& rule, Json& definitions);
Json schemaOf(Type<Range>, const Rule& rule, Json& definitions);

// The member that a file of that format begins with. Throws SessionError where it is missing, or newer than
// this program.
void expectVersion(const JsonReader& file, const FileFormat& format);

// --- enumerators, by their names

template <Named E>
void read(const JsonReader& reader, E& value, const Rule&) {
    value = reader.choice<E>(namesOf(E()));
}
template <Named E>
Json write(E value, const Rule&) {
    return nameOf(value);
}
template <Named E>
Json schemaOf(Type<E>, const Rule&, Json&) {
    return {{"enum", namesOf(E())}};
}

// --- vectors of coordinates, lists, and values that need not be there

template <int N, typename T>
void read(const JsonReader& reader, glm::vec<N, T>& value, const Rule& rule) {
    reader.expectSize(N);
    for (int i = 0; i < N; ++i) {
        read(reader.at(std::size_t(i)), value[i], rule);
    }
}
template <int N, typename T>
Json write(const glm::vec<N, T>& value, const Rule& rule) {
    Json list = Json::array();
    for (int i = 0; i < N; ++i) {
        list.push_back(write(value[i], rule));
    }
    return list;
}
template <int N, typename T>
Json schemaOf(Type<glm::vec<N, T>>, const Rule& rule, Json& definitions) {
    return {{"type", "array"},
            {"items", schemaOf(Type<T>(), rule, definitions)},
            {"minItems", N},
            {"maxItems", N}};
}

void expectCount(const JsonReader& reader, const Rule& rule);
Json listSchema(Json items, const Rule& rule);

template <typename T>
void read(const JsonReader& reader, std::vector<T>& value, const Rule& rule) {
    expectCount(reader, rule);
    value.clear();
    for (std::size_t i = 0; i < reader.size(); ++i) {
        read(reader.at(i), value.emplace_back(), rule);
    }
}
template <typename T>
Json write(const std::vector<T>& value, const Rule& rule) {
    Json list = Json::array();
    for (const T& element : value) {
        list.push_back(write(element, rule));
    }
    return list;
}
template <typename T>
Json schemaOf(Type<std::vector<T>>, const Rule& rule, Json& definitions) {
    return listSchema(schemaOf(Type<T>(), rule, definitions), rule);
}

template <typename T>
inline constexpr bool isOptional = false;
template <typename T>
inline constexpr bool isOptional<std::optional<T>> = true;

// Where null is allowed it means that the innermost optional value is not there; an outer one that is set
// then says that null was given.
template <typename T>
void read(const JsonReader& reader, std::optional<T>& value, const Rule& rule) {
    if (!isOptional<T> && rule.mayBeNull && reader.isNull()) {
        value.reset();
    } else {
        T inner{};
        read(reader, inner, rule);
        value = std::move(inner);
    }
}
template <typename T>
Json write(const std::optional<T>& value, const Rule& rule) {
    return value ? write(*value, rule) : Json();
}
template <typename T>
Json schemaOf(Type<std::optional<T>>, const Rule& rule, Json& definitions) {
    Json inner = schemaOf(Type<T>(), rule, definitions);
    if (isOptional<T> || !rule.mayBeNull) {
        return inner;
    }
    return {{"oneOf", Json::array({std::move(inner), {{"type", "null"}}})}};
}

} // namespace vs
