// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/description.h"

namespace vs::studio {

// What an operation does to the document.
enum class Effect {
    ChangesView, // changes the view
    Cuts,        // cuts the sculpture (or restores some of it)
    ClearsCuts,  // makes the sculpture whole
    Parts,       // places pasted parts
    Lays,        // says where the scan's voxels lie
    Segments,    // changes segments, or what they may grow into
    Travels,     // goes back and forward in the history
    Fills,       // adds material, or takes it away
    Marks,       // lays colours on the material, or takes them away
    Measures,    // changes the list of measurements
    Remarks,     // changes nothing that can be seen: stands in the history to be read
    Writes       // writes a file
};

// What an operation is called and what it does. It stands in the operation's struct as kAbout, beside its
// members and their description (base/description.h):
//
//     struct Rewind {
//         static constexpr About kAbout{"rewind", Effect::Segments, "plays backward"};
//         int generations = 1;
//         template <typename = void>
//         static constexpr auto fields() {
//             return std::tuple{required("generations", &Rewind::generations, kGenerations, "how many")};
//         }
//     };
struct About {
    const char* name; // in files, reports and the history
    Effect effect;
    const char* meaning; // one line for the table of doc/session.md
    const char* icon = "labels";
};

} // namespace vs::studio
