// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "studio/editing/outcome.h"
#include "studio/operations/operation.h"

namespace vs::studio {

struct Contents;
class CutEditor;
class OperationLog;

// A stroke that goes on: what the pen does now is seen at once. commit() appends one operation and one undo
// step, the same as Document::apply() of that operation would have given; discard() leaves no trace. Nothing
// else may be done with the document meanwhile. Of a scan that is worked on at a coarser level, what is seen
// at once is that level, and commit() cuts the finest (doc/decisions/0042).
class LiveStroke {
public:
    // All three must outlive it.
    LiveStroke(Contents& contents, CutEditor& cuts, OperationLog& log)
        : contents_(contents), cuts_(cuts), log_(log) {}

    // A Peel, Drill, Laser or Clip, or a Fill or Unfill by one; what it says of layers, pen points and planes
    // is done already.
    void begin(Operation operation);
    void peelTo(double layers);               // the total so far; fewer than before puts layers back
    void drawAt(const sculpt::PenPoint& pen); // drill and laser
    void clipTo(const Clip& clip);            // instead of the one before
    // The pen was led by a hand, from which points on straight stretches may be left out where each costs
    // much; without, what commit() appends has all of them.
    void setByHand() { isByHand_ = true; }
    [[nodiscard]] bool isOpen() const;
    // The operation that commit() would append.
    [[nodiscard]] Operation operation() const;
    Outcome commit();
    void discard();

private:
    template <typename Stroke>
    [[nodiscard]] Stroke& stroke();

    Contents& contents_;
    CutEditor& cuts_;
    OperationLog& log_;
    Timer timer_;
    bool isByHand_ = false;
};

} // namespace vs::studio
