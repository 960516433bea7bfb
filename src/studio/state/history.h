// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "sculpt/sculpture/sculpture_delta.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"
#include "studio/state/filled.h"
#include "studio/state/measured.h"
#include "studio/state/pasted_parts.h"
#include "studio/state/region_undo.h"
#include "studio/state/spill_file.h"

#include <memory>
#include <optional>
#include <vector>

namespace vs::studio {

// One undoable edit: the operation, and what takes it back. A cut is a delta of bricks that swaps both ways;
// a change of the region is undone by its records, newest first, and redone by applying the operation again.
struct Edit {
    // Shared with those who show what undo and redo go through.
    std::shared_ptr<const Operation> operation;
    std::optional<sculpt::SculptureDelta> cut;
    std::vector<RegionUndo> growth;
    // Pasted parts before and after, where the operation changed them.
    std::optional<PastedState> partsBefore = {};
    std::optional<PastedState> partsAfter = {};
    // The segments' names and appearance before and after, where the operation changed them.
    std::optional<SegmentList> segmentsBefore = {};
    std::optional<SegmentList> segmentsAfter = {};
    // Where the scan's voxels lay before and after, where the operation corrected that.
    std::optional<volume::GridGeometry> geometryBefore = {};
    std::optional<volume::GridGeometry> geometryAfter = {};
    // The measurements before and after, where the operation changed them.
    Measurements measurementsBefore = {};
    Measurements measurementsAfter = {};
    // The marks before and after, where the operation changed them; both share what they have in common.
    field::SharedMarks marksBefore = {};
    field::SharedMarks marksAfter = {};
    // What is filled before and after, where the operation changed it; they share bricks, too.
    std::optional<Filled> filledBefore = {};
    std::optional<Filled> filledAfter = {};
    // What it changed of what was trimmed (sculpt::Trimmed); it stays in memory.
    std::optional<sculpt::BrickDelta> trim = {};
    bool isLimited = false; // the cut spared segments, or took nothing else
    // What numbers the sculpture's contents since its cut (sculpt::Sculpture::contentVersion()); undo and
    // redo give them that number again, by which growth knows the fence that it grew at. Nothing: there is no
    // cut, or an older file did not say.
    std::optional<std::uint64_t> cutContent = {};
    // Where the cut's contents are while they are not in memory; History's own business.
    std::optional<SpillFile::Block> spilled = {};
};

// An operation as edits have it.
inline std::shared_ptr<const Operation> shared(Operation operation) {
    return std::make_shared<const Operation>(std::move(operation));
}

// What undo and redo of cuts hold: their contents, without the lists of bricks (some 30 bytes a brick).
struct UndoStatistics {
    std::size_t steps = 0;         // that can be undone or redone
    std::size_t bytesInMemory = 0; // of the cuts among them
    std::uint64_t bytesInFile = 0;
    std::uint64_t fileBytes = 0; // length of the temporary file, with gaps
    std::size_t changedVoxels = 0;

    [[nodiscard]] double bytesPerChangedVoxel() const {
        return changedVoxels == 0 ? 0 : double(bytesInMemory + bytesInFile) / double(changedVoxels);
    }
};

// Undo and redo without limit. A new step forgets what could be redone. When the cuts' contents come to more
// than memoryLimit() bytes, those farthest from being needed go to a temporary file. If that cannot be
// written, everything stays in memory and a notice says so once. What throws std::bad_alloc has changed
// nothing.
class History {
public:
    static constexpr std::size_t kUsualMemoryLimit = std::size_t(512) << 20;

    History() = default;
    // The temporary file lies in `folder`.
    explicit History(const std::filesystem::path& folder) : file_(folder) {}

    [[nodiscard]] std::size_t memoryLimit() const { return memoryLimit_; }
    void setMemoryLimit(std::size_t bytes);

    // Makes room for one step more, so that one push() and each move between undo and redo need no memory.
    void makeRoom();
    void push(Edit edit);
    // The last push() is as if it had never been: what could be redone before it can be again. Only until
    // settle(), which makes it last.
    void unpush() noexcept;
    void settle() noexcept;
    [[nodiscard]] bool isSettled() const { return !canUnpush_; }
    // The step that undo would take back is no more; its cut, if any, must be in memory.
    void forgetLast();
    // The last two edits (both changes of the region alone) become one, done by this operation.
    void mergeLastTwo(std::shared_ptr<const Operation> operation);
    [[nodiscard]] bool canUndo() const { return !done_.empty(); }
    [[nodiscard]] bool canRedo() const { return !undone_.empty(); }
    // What holds, the oldest first; and what was undone, the next to redo last.
    [[nodiscard]] const std::vector<Edit>& done() const { return done_; }
    [[nodiscard]] const std::vector<Edit>& undone() const { return undone_; }
    [[nodiscard]] UndoStatistics statistics() const;
    // The contents that an edit's cut holds, wherever they are. Throws ReadError.
    [[nodiscard]] std::vector<std::byte> heldBy(const Edit& edit) const;
    // Becomes what was kept in a file; there must be no steps yet.
    void restore(std::vector<Edit> done, std::vector<Edit> undone);

    // The operation of the step that undo would take back; there must be one.
    [[nodiscard]] const Operation& lastOperation() const { return *done_.back().operation; }
    // Counts changes of all this.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    // What numbers the sculpture's contents without the step to take back, where that is known.
    [[nodiscard]] std::optional<std::uint64_t> contentBeforeLast() const;

    // The step to take back, in memory; once that is done, tookBack() makes it the one to redo. Throws
    // ReadError when it cannot be read back from the file.
    Edit& toUndo() { return inMemory(done_.back()); }
    void tookBack() noexcept { move(done_, undone_); }
    // The step to apply again, in memory; once that is done, appliedAgain() makes it the one to undo.
    Edit& toRedo() { return inMemory(undone_.back()); }
    void appliedAgain() noexcept { move(undone_, done_); }

private:
    void move(std::vector<Edit>& from, std::vector<Edit>& to) noexcept;
    Edit& inMemory(Edit& edit);
    void forget(std::vector<Edit>& edits) noexcept;
    void keepToLimit() noexcept;
    void spillWhatIsTooMuch();
    void spill(Edit& edit);

    std::vector<Edit> done_;
    std::vector<Edit> undone_;   // the next to redo last
    std::vector<Edit> replaced_; // what could be redone before the last push()
    SpillFile file_;
    std::size_t memoryLimit_ = kUsualMemoryLimit;
    bool hasComplained_ = false;
    bool canUnpush_ = false;
    std::uint64_t revision_ = 0;
};

} // namespace vs::studio
