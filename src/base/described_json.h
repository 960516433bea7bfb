// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/value_json.h"

#include <string_view>
#include <type_traits>
#include <variant>

namespace vs {

// Reads and writes everything that has a description (base/description.h). For the files that read and write
// files; others use their functions.

template <Described T>
void read(const JsonReader& reader, T& value, const Rule& rule);
template <Described T>
Json write(const T& value, const Rule& rule);

// An operation is told by its name, the member "op".
template <typename T>
inline constexpr bool isOperation = requires {
    T::kAbout;
};
template <typename T>
inline constexpr bool isFile = requires {
    T::kFormat;
};

// A value that stands in files as one of another, described type InFiles, which is made of it, and gives it
// back by value().
template <typename T>
concept StandsAsAnother = requires {
    typename T::InFiles;
};

// --- reading

// The names in files of those of a struct's fields that `isMeant`.
template <typename T, typename Fields, typename IsMeant>
void addNames(const Fields& fields, std::vector<const char*>& names, IsMeant isMeant) {
    forEachField(fields, [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Spread) {
            addNames<ValueOf<T, F>>(ValueOf<T, F>::fields(), names, [](const auto&) { return true; });
        } else {
            const auto isIt = [&](const char* name) { return std::string_view(name) == field.name; };
            if (isMeant(field) && std::none_of(names.begin(), names.end(), isIt)) {
                names.push_back(field.name);
            }
        }
    });
}

// All names that `isMeant`, with those that are not fields.
template <Described T, typename IsMeant>
std::vector<const char*> namesOfFields(IsMeant isMeant) {
    std::vector<const char*> names;
    if constexpr (isOperation<T>) {
        names.push_back("op");
    }
    if constexpr (isFile<T>) {
        names.push_back(T::kFormat.member);
    }
    addNames<T>(T::fields(), names, isMeant);
    return names;
}

template <typename F>
bool isLeftOut(const F& field, const Rule& rule) {
    return *rule.without != '\0' && std::string_view(rule.without) == field.name;
}

// The fields that others depend on.
template <Described T>
void readDeciding(const JsonReader& reader, T& value) {
    forEachField(T::fields(), [&]<typename F>(const F& field) {
        if constexpr (F::kPresence == Presence::Required || F::kPresence == Presence::Sparse) {
            if (!field.decides || !field.applies(value)) {
                return;
            }
            if (!reader.has(field.name) && F::kPresence == Presence::Required) { // it may be misspelt
                reader.allow(namesOfFields<T>([](const auto&) { return true; }));
            }
            if (reader.has(field.name) || F::kPresence == Presence::Required) {
                read(reader.member(field.name), valueOf(value, field.access), field.rule);
            }
        }
    });
}

template <typename T, typename Fields>
void readFields(const JsonReader& reader, T& value, const Fields& fields, const Rule& rule) {
    forEachField(fields, [&]<typename F>(const F& field) {
        auto& member = valueOf(value, field.access);
        if constexpr (F::kPresence == Presence::Group) {
            if (reader.has(field.name)) {
                const JsonReader inner = reader.member(field.name);
                std::vector<const char*> names;
                addNames<T>(field.inner, names, [](const auto&) { return true; });
                inner.allow(names);
                readFields(inner, value, field.inner, rule);
            }
        } else if constexpr (F::kPresence == Presence::Spread) {
            readFields(reader, member, ValueOf<T, F>::fields(), {});
        } else if (field.mayStandIn(value) && !isLeftOut(field, rule) &&
                   (F::kPresence == Presence::Required ? field.applies(value) : reader.has(field.name))) {
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
void readDescribed(const JsonReader& reader, T& value, const Rule& rule) {
    if constexpr (isFile<T>) {
        expectVersion(reader, T::kFormat);
    }
    readDeciding(reader, value);
    reader.allow(namesOfFields<T>(
        [&](const auto& field) { return field.mayStandIn(value) && !isLeftOut(field, rule); }));
    readFields(reader, value, T::fields(), rule);
    if constexpr (requires { T::kNeedsOneOf; }) {
        expectOneOf(reader, T::kNeedsOneOf);
    }
    if constexpr (requires { value.faultOf(); }) {
        if (const Fault fault = value.faultOf(); !fault.wanted.empty()) {
            reader.failAt(fault.place, fault.wanted);
        }
    }
}

template <Described T>
void read(const JsonReader& reader, T& value, const Rule& rule) {
    readDescribed(reader, value, rule);
}
template <StandsAsAnother T>
void read(const JsonReader& reader, T& value, const Rule& rule) {
    typename T::InFiles standing;
    read(reader, standing, rule);
    value = std::move(standing).value();
}

// --- writing

template <typename T, typename Fields>
void writeFields(Json& json, const T& value, const Fields& fields, const Rule& rule) {
    forEachField(fields, [&]<typename F>(const F& field) {
        const auto& member = valueOf(value, field.access);
        if constexpr (F::kPresence == Presence::Group) {
            Json inner = Json::object();
            writeFields(inner, value, field.inner, rule);
            json[field.name] = std::move(inner);
        } else if constexpr (F::kPresence == Presence::Spread) {
            writeFields(json, member, ValueOf<T, F>::fields(), {});
        } else if (!field.applies(value) || isLeftOut(field, rule)) {
            return;
        } else if constexpr (F::kPresence == Presence::Sparse) {
            static const T byDefault{};
            if (!(member == valueOf(byDefault, field.access))) {
                json[field.name] = write(member, field.rule);
            }
        } else {
            json[field.name] = write(member, field.rule);
        }
    });
}

template <Described T>
Json writeDescribed(const T& value, const Rule& rule) {
    Json json = Json::object();
    if constexpr (isOperation<T>) {
        json["op"] = T::kAbout.name;
    }
    if constexpr (isFile<T>) {
        json[T::kFormat.member] = T::kFormat.version;
    }
    writeFields(json, value, T::fields(), rule);
    return json;
}

template <Described T>
Json write(const T& value, const Rule& rule) {
    return writeDescribed(value, rule);
}
template <StandsAsAnother T>
Json write(const T& value, const Rule& rule) {
    return write(typename T::InFiles(value), rule);
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

} // namespace vs
