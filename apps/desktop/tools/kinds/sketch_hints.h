// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "model/hand/tool.h"

#include <QString>

namespace vs::desktop {

class StudioController;

// What happens when a sketch ends. Every tool that is drawn with says it in the same words.
enum class SketchEnd { Mask, Cut, Restore, Remove, Add, Seed, Absorb, Fill, Mark, MarkArea };

// Why the segment at work cannot be changed; empty: it can.
QString lockedHint(StudioController& studio);
// How a shape is drawn, for a tool that has nothing in hand yet: "Drag from its centre to its rim."
QString howToDraw(studio::Shape shape, SketchPad::Needs needs = SketchPad::Needs::Area);
// What to do next with the sketch in hand, and what that comes to.
QString sketchHint(const SketchPad& pad, SketchEnd end);

// The sketch in hand: the line as drawn, what it comes to if it ends now, and where a click closes it. Lines
// are as wide (logical pixels) as what they mark.
Overlays sketchOverlays(const SketchPad& pad, Overlay::Tint tint, double lineWidth = 2);

} // namespace vs::desktop
