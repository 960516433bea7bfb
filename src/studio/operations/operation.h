// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/housekeeping.h"
#include "studio/operations/sculpting.h"
#include "studio/operations/segmenting.h"
#include "studio/operations/sweeping.h"

#include <variant>

namespace vs::studio {

// The operations: one document change each, as values. The window, the command line and a replayed session
// all make these, and nothing else changes a document. doc/contributing.md says how to add one.
using Operation = std::variant<SetView, Peel, Drill, Laser, Sweep, Scissors, Clip, KeepConnected, Paste,
                               MovePart, Seed, Grow, Rewind, ShowGeneration, SetGrowthRules, Absorb,
                               UseSegment, LoadLabels, RemoveSegment, EditSegment, BrushSegment, PaintSegment,
                               CutSegment, Undo, Redo, UnCut, ReSeed, SavePicture, SaveLabels, SaveSculpture>;

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
