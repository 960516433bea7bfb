// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <tuple>

namespace vs::studio {

// How operations, and what they are made of, are described. A struct says beside its members what each is
// called in files, what it may be and what it means; reading and writing it, its part of the schema and of
// the documentation are derived from that alone (studio/json). A description is a tuple of fields, in the
// order in which they stand in files:
//
//     struct Rewind {
//         static constexpr About kAbout{"rewind", Effect::Segments, "plays backward"};
//         int generations = 1;
//         template <typename = void>
//         static constexpr auto fields() {
//             return std::tuple{required("generations", &Rewind::generations, kGenerations, "how many")};
//         }
//     };
//
// fields() is a template so that only the few files that use it pay for its making when they are compiled.

// What a value may be. Bounds hold for every number in it: for each coordinate, for each element of a list.
struct Rule {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    const char* unit = "";
    std::span<const int> among = {};           // of whole numbers: only these
    std::span<const char* const> choices = {}; // texts that stand for 0, 1, 2, ...
    std::size_t leastCount = 0;                // elements of a list, characters of a text
    std::size_t mostCount = std::numeric_limits<std::size_t>::max();
    bool isOutputFile = false; // a text: the name of a file inside the output folder
    bool mayBeNull = false;    // an optional value, of which null means that there is none

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
// object; it depends on fields that stand before it.
template <Presence P, typename Access, typename Condition = Always, typename Inner = std::tuple<>>
struct Field {
    static constexpr Presence kPresence = P;
    const char* name;
    Access access;
    Rule rule;
    const char* meaning;
    Condition applies;
    Inner inner; // the fields of a group

    // This field, with a condition: it only means something where `condition` holds.
    template <typename When>
    constexpr auto when(When condition) const {
        return Field<P, Access, When, Inner>{name, access, rule, meaning, condition, inner};
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

// Where the description of a type stands: in the struct itself, or, for a struct of another module, in a
// specialization that says so.
template <typename T>
struct Description {
    static constexpr bool isElsewhere = false;
    static constexpr auto fields() { return T::fields(); }
    static constexpr const char* name() { return T::kName; } // of the type, in the schema
};

template <typename T>
concept Described = Description<T>::isElsewhere || requires {
    T::fields();
};

// Calls `visit` with each field of a tuple of fields, in their order.
template <typename Fields, typename Visit>
constexpr void forEachField(const Fields& fields, Visit visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, fields);
}

// What is wrong with a value whose members are right one by one: which field, or none for all of it, and what
// would be right. A described struct may have a member faultOf() that returns it; no text: nothing is wrong.
struct Fault {
    const char* field = "";
    std::string wanted;
};

// What an operation does to the document.
enum class Effect {
    Looks,      // changes the view
    Cuts,       // cuts the sculpture (or restores some of it)
    ClearsCuts, // makes the sculpture whole
    Parts,      // places pasted parts
    Segments,   // changes segments, or what they may grow into
    Travels,    // goes back and forward in the history
    Remarks,    // changes nothing that can be seen: stands in the history to be read
    Writes      // writes a file
};

// What an operation is called and what it does.
struct About {
    const char* name; // in files, reports and the history
    Effect effect;
    const char* meaning; // one line for the table of doc/session.md
    const char* icon = "labels";
};

} // namespace vs::studio
