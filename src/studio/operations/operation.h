// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/correcting.h"
#include "studio/operations/filling.h"
#include "studio/operations/filming.h"
#include "studio/operations/housekeeping.h"
#include "studio/operations/marking.h"
#include "studio/operations/measuring.h"
#include "studio/operations/sculpting.h"
#include "studio/operations/segmenting.h"
#include "studio/operations/sweeping.h"

#include <variant>

namespace vs::studio {

template <typename... Variants>
struct JoinedVariants;
template <typename... A>
struct JoinedVariants<std::variant<A...>> {
    using Type = std::variant<A...>;
};
template <typename... A, typename... B, typename... More>
struct JoinedVariants<std::variant<A...>, std::variant<B...>, More...>
    : JoinedVariants<std::variant<A..., B...>, More...> {};

// The operations: one document change each, as values. The window, the command line and a replayed session
// all make these, and nothing else changes a document. doc/contributing.md says how to add one.
using Operation =
    JoinedVariants<std::variant<SetView>, SculptingOperations, SweepingOperations, SegmentingOperations,
                   MeasuringOperations, CorrectingOperations, HousekeepingOperations, FilmingOperations,
                   MarkingOperations, FillingOperations>::Type;

// What an operation is called, what it does, and its icon.
const About& about(const Operation& operation);
// What each of them is called, in the order of the variant.
std::vector<const char*> operationNames();

// The name in sessions, reports and the history: "view", "peel", ...
const char* name(const Operation& operation);

// What there is to say of an operation besides its name, for the history: "3.5 layers", "restore".
std::vector<Phrase> details(const Operation& operation);

// Whether an operation is a stroke or another cut of the sculpture (or restores some of it).
bool cuts(const Operation& operation);

// Whether an operation changes the document; looking and writing files do not.
bool isEdit(const Operation& operation);

// Whether an operation only writes a file and leaves the document as it is.
bool isOutput(const Operation& operation);

} // namespace vs::studio
