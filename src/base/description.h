// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>

namespace vs {

// How structs that stand in files are described: operations, transfer functions, and what they are made of.
// A struct says beside its members what each is called in files, what it may be and what it means; reading
// and writing it (base/described_json.h), its part of a schema and of the documentation are derived from that
// alone. A description is a tuple of fields, in the order in which they stand in files:
//
//     struct Lighting {
//         static constexpr const char* kName = "lighting";
//         double amount = 1;
//         template <typename = void>
//         static constexpr auto fields() {
//             return std::tuple{written("amount", &Lighting::amount, {.least = 0, .most = 1}, "how much")};
//         }
//     };
//
// kName is what the struct is called in schemas and tables. fields() is a template so that only the few files
// that use it pay for its making when they are compiled.

// What a value may be. Bounds hold for every number in it: for each coordinate, for each element of a list.
struct Rule {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    const char* unit = "";
    std::span<const int> among = {};           // of whole numbers: only these
    std::span<const char* const> choices = {}; // texts that stand for 0, 1, 2, ...; of a text: only these
    std::size_t leastCount = 0;                // elements of a list, characters of a text
    std::size_t mostCount = std::numeric_limits<std::size_t>::max();
    // What is said when a list has fewer or more elements, if not the general words; {0} stands for how many
    // it has, {1} and {2} for leastCount and mostCount.
    const char* wrongCount = "";
    const char* without = "";  // of a described struct: the name of a field that it does not have here
    bool isOutputFile = false; // a text: the name of a file inside the output folder
    bool mayBeNull = false;    // an optional value, of which null means that there is none
    bool isReference = false;  // a text: the name of something else that is spoken of, such as a segment

    [[nodiscard]] constexpr bool hasBounds() const {
        return least > -std::numeric_limits<double>::infinity() &&
               most < std::numeric_limits<double>::infinity();
    }
};

enum class Presence {
    Required, // where the field applies at all
    Written,  // always written; may be left out by others, and is then what it is by default
    Sparse,   // written only where it is not what it is by default
    Spread,   // a described struct whose fields stand among those of this one
    Group     // several fields of this struct that stand in an object of their own
};

struct Always {
    template <typename T>
    constexpr bool operator()(const T&) const {
        return true;
    }
};
struct TheObjectItself {
    template <typename T>
    constexpr T& operator()(T& object) const {
        return object;
    }
};

// One member of a struct. `Access` gives the member of an object: a pointer to member, or a function of the
// object that returns a reference. `applies`, if there is one, says whether the field means something in an
// object; it depends on fields that decide, or that stand before it. Fields that apply in different objects
// may have the same name.
template <Presence P, typename Access, typename Condition = Always, typename Inner = std::tuple<>>
struct Field {
    static constexpr Presence kPresence = P;
    static constexpr bool kIsConditional = !std::is_same_v<Condition, Always>;
    const char* name;
    Access access;
    Rule rule;
    const char* meaning;
    Condition applies;
    Inner inner;                     // the fields of a group
    bool isRefusedElsewhere = false; // must not be given where it does not apply
    bool decides = false;            // other fields apply or not by what this one is

    // This field, which only means something where `condition` holds, and is ignored elsewhere.
    template <typename When>
    constexpr auto when(When condition) const {
        return Field<P, Access, When, Inner>{name, access, rule, meaning, condition, inner, false, decides};
    }
    // This field, which may only be given where `condition` holds.
    template <typename When>
    constexpr auto onlyWhen(When condition) const {
        return Field<P, Access, When, Inner>{name, access, rule, meaning, condition, inner, true, decides};
    }
    // This field, an enumerator or a value that need not be there, which is read before all others
    // because they depend on it.
    constexpr auto deciding() const {
        Field field = *this;
        field.decides = true;
        return field;
    }
    // Whether the field may stand in a file beside what `object` holds.
    template <typename T>
    constexpr bool mayStandIn(const T& object) const {
        return !isRefusedElsewhere || applies(object);
    }
};

template <typename Access>
constexpr auto required(const char* name, Access access, Rule rule = {}, const char* meaning = "") {
    return Field<Presence::Required, Access>{name, access, rule, meaning, {}, {}};
}
template <typename Access>
constexpr auto written(const char* name, Access access, Rule rule = {}, const char* meaning = "") {
    return Field<Presence::Written, Access>{name, access, rule, meaning, {}, {}};
}
template <typename Access>
constexpr auto sparse(const char* name, Access access, Rule rule = {}, const char* meaning = "") {
    return Field<Presence::Sparse, Access>{name, access, rule, meaning, {}, {}};
}
template <typename Access>
constexpr auto spread(Access access) {
    return Field<Presence::Spread, Access>{"", access, {}, "", {}, {}};
}
template <typename Inner>
constexpr auto group(const char* name, Inner inner, const char* meaning = "") {
    return Field<Presence::Group, TheObjectItself, Always, Inner>{name, {}, {}, meaning, {}, inner};
}

// The member of a member: through(&Canvas::view, &View::camera).
template <typename Outer, typename Inner>
constexpr auto through(Outer outer, Inner inner) {
    return [ outer, inner ](auto& object) -> auto& { return object.*outer.*inner; };
}

template <typename T, typename Access>
constexpr auto& valueOf(T& object, Access access) {
    if constexpr (std::is_member_object_pointer_v<Access>) {
        return object.*access;
    } else {
        return access(object);
    }
}

// The type of what a field F of T is.
template <typename T, typename F>
using ValueOf = std::remove_cvref_t<decltype(valueOf(std::declval<T&>(), std::declval<F>().access))>;

template <typename T>
concept Described = requires {
    T::fields();
};

// Calls `visit` with each field of a tuple of fields, in their order.
template <typename Fields, typename Visit>
constexpr void forEachField(const Fields& fields, Visit visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, fields);
}

// What is wrong with a value whose members are right one by one: where, by the names in files
// ("points[1].at"; nothing: all of it), and what would be right. A described struct may have a member
// faultOf() that returns it; no text: nothing is wrong.
struct Fault {
    std::string place;
    std::string wanted;
};

// A struct with a member kFormat is a file of its own: the name of the member that its files begin with, and
// the newest version of the format.
struct FileFormat {
    const char* member;
    int version;
};

} // namespace vs
