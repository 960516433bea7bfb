// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/json/value_json.h"

#include <type_traits>

namespace vs::studio {

// Reads and writes everything that has a description (operations/description.h). Private
// to the files that read and write operations.

template <Described T>
void read(const JsonReader& reader, T& value, const Rule& rule);
template <Described T>
Json write(const T& value, const Rule& rule);

template <typename T>
inline constexpr bool isOperation = requires {
    T::kAbout;
};

// --- reading

// The type of what a field of T is.
template <typename T, typename F>
using ValueOf = std::remove_cvref_t<decltype(valueOf(std::declval<T&>(), std::declval<F>().access))>;

// The names of a struct's members in files.
template <typename T, typename Fields>
void addNames(const Fields& fields, std::vector<const char*>& names) {
    forEachField(fields, [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Spread) {
            addNames<ValueOf<T, F>>(Description<ValueOf<T, F>>::fields(), names);
        } else {
            names.push_back(field.name);
        }
    });
}

template <typename T, typename Fields>
void readFields(const JsonReader& reader, T& value, const Fields& fields) {
    forEachField(fields, [&]<typename F>(const F& field) {
        auto& member = valueOf(value, field.access);
        if constexpr (F::kPresence == Presence::Group) {
            if (reader.has(field.name)) {
                const JsonReader inner = reader.member(field.name);
                std::vector<const char*> names;
                addNames<T>(field.inner, names);
                inner.allow(names);
                readFields(inner, value, field.inner);
            }
        } else if constexpr (F::kPresence == Presence::Spread) {
            readFields(reader, member, Description<ValueOf<T, F>>::fields());
        } else if (F::kPresence == Presence::Required ? field.applies(value) : reader.has(field.name)) {
            read(reader.member(field.name), member, field.rule);
        }
    });
}

// A list that is empty is as good as none.
inline bool isGiven(const JsonReader& reader, const char* name) {
    return reader.has(name) && !(reader.json().at(name).is_array() && reader.json().at(name).empty());
}

inline void expectOneOf(const JsonReader& reader, std::span<const char* const> names) {
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (isGiven(reader, names[i])) {
            return;
        }
        all += (i == 0 ? "'" : i + 1 < names.size() ? ", '" : " or '") + std::string(names[i]) + "'";
    }
    reader.fail("needs " + all);
}

template <Described T>
void read(const JsonReader& reader, T& value, const Rule&) {
    std::vector<const char*> known;
    if constexpr (isOperation<T>) {
        known.push_back("op");
    }
    addNames<T>(Description<T>::fields(), known);
    reader.allow(known);
    readFields(reader, value, Description<T>::fields());
    if constexpr (requires { T::kNeedsOneOf; }) {
        expectOneOf(reader, T::kNeedsOneOf);
    }
    if constexpr (requires { value.faultOf(); }) {
        if (const Fault fault = value.faultOf(); !fault.wanted.empty()) {
            (*fault.field == '\0' ? reader : reader.member(fault.field)).fail(fault.wanted);
        }
    }
}

// --- writing

template <typename T, typename Fields>
void writeFields(Json& json, const T& value, const Fields& fields) {
    forEachField(fields, [&]<typename F>(const F& field) {
        const auto& member = valueOf(value, field.access);
        if constexpr (F::kPresence == Presence::Group) {
            Json inner = Json::object();
            writeFields(inner, value, field.inner);
            json[field.name] = std::move(inner);
        } else if constexpr (F::kPresence == Presence::Spread) {
            writeFields(json, member, Description<ValueOf<T, F>>::fields());
        } else if constexpr (F::kPresence == Presence::Sparse) {
            static const T byDefault{};
            if (field.applies(value) && !(member == valueOf(byDefault, field.access))) {
                json[field.name] = write(member, field.rule);
            }
        } else if (field.applies(value)) {
            json[field.name] = write(member, field.rule);
        }
    });
}

template <Described T>
Json write(const T& value, const Rule&) {
    Json json = Json::object();
    if constexpr (isOperation<T>) {
        json["op"] = T::kAbout.name;
    }
    writeFields(json, value, Description<T>::fields());
    return json;
}

// --- one of several operations, by its name

template <typename... Ops>
void read(const JsonReader& reader, std::variant<Ops...>& value, const Rule& rule) {
    constexpr std::array<const char*, sizeof...(Ops)> names{Ops::kAbout.name...};
    const std::size_t index = reader.member("op").indexAmong(names);
    std::size_t i = 0;
    const auto readIfMeant = [&]<typename Op>(Type<Op>) {
        if (i++ == index) {
            read(reader, value.template emplace<Op>(), rule);
        }
    };
    (readIfMeant(Type<Ops>()), ...);
}
template <typename... Ops>
Json write(const std::variant<Ops...>& value, const Rule& rule) {
    return std::visit([&](const auto& op) { return write(op, rule); }, value);
}
} // namespace vs::studio
