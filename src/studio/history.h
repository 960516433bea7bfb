// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sculpt/brick_backup.h"
#include "segment/growth_undo.h"
#include "studio/operation.h"
#include "studio/pasted_parts.h"

#include <optional>
#include <vector>

namespace vs::studio {

// One undoable edit: the operation, and what takes it back. A cut is a delta of bricks that swaps both ways;
// a change of the region is undone by its records, newest first, and redone by applying the operation again.
struct Step {
    Operation operation;
    std::optional<sculpt::BrickDelta> cut;
    std::vector<segment::GrowthUndo> growth;
    // Pasted parts before and after, where the operation changed them.
    std::optional<PastedState> partsBefore = {};
    std::optional<PastedState> partsAfter = {};
};

// Undo and redo without limit. A new step forgets what could be redone.
class History {
public:
    void push(Step step) {
        done_.push_back(std::move(step));
        undone_.clear();
    }
    // The last two steps (both changes of the region alone) become one.
    void mergeLastTwo() {
        Step last = std::move(done_.back());
        done_.pop_back();
        for (auto& record : last.growth) {
            done_.back().growth.push_back(std::move(record));
        }
    }
    [[nodiscard]] bool canUndo() const { return !done_.empty(); }
    [[nodiscard]] bool canRedo() const { return !undone_.empty(); }

    // The step to take back; once that is done, tookBack() makes it the one to redo.
    Step& toUndo() { return done_.back(); }
    [[nodiscard]] const Step& toUndo() const { return done_.back(); }
    void tookBack() { move(done_, undone_); }
    // The step to apply again; once that is done, appliedAgain() makes it the one to undo.
    Step& toRedo() { return undone_.back(); }
    void appliedAgain() { move(undone_, done_); }

private:
    static void move(std::vector<Step>& from, std::vector<Step>& to) {
        to.push_back(std::move(from.back()));
        from.pop_back();
    }

    std::vector<Step> done_;
    std::vector<Step> undone_;
};

} // namespace vs::studio
