// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/edits/voxel_set.h"
#include "studio/editing/contents.h"
#include "studio/editing/display.h"
#include "studio/editing/outcome.h"
#include "studio/editing/tool_limits.h"
#include "studio/strokes/cut_stroke.h"

#include <memory>

namespace vs::studio {

// A pen's stroke without the points on straight stretches of its way, each of which costs as much as a
// stretch; where it digs deeper at each, they mean more than the way, and stay. Other operations as they are.
Operation withoutDetours(Operation operation);

// Carries out the operations that cut and restore, and those that fill by a stroke and take that away, all at
// once or as a stroke that is seen while it goes on.
// run() writes what the stroke has found into the operation and remembers it as a step; it throws Error
// before anything has changed. If something is thrown in the midst of a stroke (a device without room),
// everything is as before.
class CutEditor {
public:
    // All three must outlive it.
    CutEditor(Contents& contents, Display& display, Cutter& cutter)
        : contents_(contents), display_(display), cutter_(cutter) {}

    Outcome run(Peel& op);
    Outcome run(Drill& op);
    Outcome run(Laser& op);
    Outcome run(Sweep& op);
    Outcome run(Scissors& op);
    Outcome run(Clip& op);
    Outcome run(KeepConnected& op);
    Outcome run(CutSegment& op);
    Outcome run(Fill& op);
    Outcome run(FillHole& op);
    Outcome run(Unfill& op);

    // Opens the stroke of an operation that cuts, whose canvas is set, within the limits that hold for tools;
    // then there is a stroke(), until finish() makes a step of it or discard() leaves no trace.
    void begin(const Operation& operation);
    // Does so for a stroke in hand, which must be seen at once: of a scan that is worked on at a coarser
    // level, that level alone is cut, roughly, until settle() cuts the finest.
    void beginInHand(const Operation& operation);
    // If the stroke was cut roughly, opens one that cuts as `operation` says instead, and replays it. When it
    // throws, and isOpen() does not hold, there is no stroke any more, and everything is as before.
    void settle(const Operation& operation);
    [[nodiscard]] bool isRough() const { return contents_.sculpture.isRough(); }
    [[nodiscard]] bool isOpen() const { return stroke_ != nullptr; }
    [[nodiscard]] CutStroke& stroke() { return *stroke_; }
    [[nodiscard]] const CutStroke& stroke() const { return *stroke_; }
    // The operation that the stroke has become so far.
    [[nodiscard]] Operation operation() const;
    Outcome finish();
    void discard();

    // The voxels that a stroke would cut, and for adding only those that the view shows: the sculpture is
    // left as it was.
    segment::VoxelSet wouldCut(const BrushSegment& op);
    // Does that for voxels of the finest level, where segments grow at that one.
    segment::FineSet wouldCutFinest(const BrushSegment& op);

private:
    template <typename Cut>
    Outcome cutAtOnce(Cut& op);
    void begin(Cutter& cutter, const Operation& operation);
    // A stroke without limits.
    void open(Cutter& cutter, const Operation& operation, const Cutter::Aim& aim = {});
    void forget(); // the stroke
    segment::VoxelSet takeBackAndTell(sculpt::SculptureDelta& delta, const std::optional<Range>& seen);
    segment::FineSet takeBackAndTellFinest(sculpt::SculptureDelta& delta);
    // The range that what a brush adds must lie in.
    [[nodiscard]] std::optional<Range> seenBy(const BrushSegment& op) const;
    // Cuts along a brush's stroke; takeBackAndTell(delta) puts the sculpture back and gives what is returned.
    template <typename Tell>
    auto cutAndTakeBack(const BrushSegment& op, Tell takeBackAndTell);
    // Remembers a cut that has been made as a step, with what it does to what is trimmed. If there is no
    // memory for that, it throws, and whoever made the cut must take it back.
    void remember(const Operation& operation, sculpt::SculptureDelta& cut, bool isLimited);
    [[nodiscard]] Phrase saidOf(std::size_t changedVoxels) const;
    template <typename Filling>
    Outcome fillAtOnce(Filling& op);
    void checkFilling(const Cutter::Aim& aim) const;

    Contents& contents_;
    Display& display_;
    Cutter& cutter_;
    ToolLimits limits_;
    std::unique_ptr<CutStroke> stroke_; // the one that is open
    Cutter::Aim aim_;                   // and what it changes
};

} // namespace vs::studio
