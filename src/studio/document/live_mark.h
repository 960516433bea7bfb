// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "sculpt/surface/stroke.h"
#include "studio/editing/outcome.h"
#include "studio/operations/marking.h"

namespace vs::studio {

struct Contents;
class MarkEditor;
class OperationLog;

// A line of a marking pen that goes on: what the pen does now is seen at once. commit() appends one operation
// and one undo step, the same as Document::apply() of that operation would have given; discard() leaves no
// trace. Nothing else may be done with the document meanwhile.
class LiveMark {
public:
    // All three must outlive it.
    LiveMark(Contents& contents, MarkEditor& marks, OperationLog& log)
        : contents_(contents), marks_(marks), log_(log) {}

    // A line without points.
    void begin(Mark mark);
    void drawAt(const sculpt::PenPoint& pen);
    [[nodiscard]] bool isOpen() const;
    Outcome commit();
    void discard();

private:
    Contents& contents_;
    MarkEditor& marks_;
    OperationLog& log_;
    Timer timer_;
};

} // namespace vs::studio
