// SPDX-License-Identifier: Apache-2.0
#include "studio/state/history.h"

#include "base/check.h"
#include "base/error.h"
#include "base/log.h"

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>

namespace vs::studio {

static_assert(std::is_nothrow_move_constructible_v<Edit> && std::is_nothrow_move_assignable_v<Edit>);

namespace {

std::size_t bytesInMemory(const std::vector<Edit>& edits) {
    std::size_t bytes = 0;
    for (const Edit& edit : edits) {
        bytes += edit.cut ? edit.cut->held().size() : 0;
        bytes += edit.trim ? edit.trim->held().size() : 0;
    }
    return bytes;
}

} // namespace

void History::setMemoryLimit(std::size_t bytes) {
    memoryLimit_ = bytes;
    hasComplained_ = false;
    keepToLimit();
}

void History::forgetLast() {
    done_.pop_back();
    ++revision_;
}

void History::makeRoom() {
    // Whatever can be undone can be redone, and the other way round. Doubled where more is needed, as
    // push_back() does.
    const std::size_t most = done_.size() + undone_.size() + 1;
    for (std::vector<Edit>* edits : {&done_, &undone_, &replaced_}) {
        if (edits->capacity() < most) {
            edits->reserve(2 * most);
        }
    }
}

void History::push(Edit edit) {
    makeRoom();
    settle();
    replaced_.swap(undone_);
    done_.push_back(std::move(edit));
    canUnpush_ = true;
    keepToLimit();
}

void History::unpush() noexcept {
    done_.pop_back();
    undone_.swap(replaced_);
    canUnpush_ = false;
    ++revision_;
}

void History::settle() noexcept {
    forget(replaced_);
    canUnpush_ = false;
}

void History::mergeLastTwo(std::shared_ptr<const Operation> operation) {
    auto& records = done_[done_.size() - 2].growth;
    auto& added = done_.back().growth;
    records.reserve(records.size() + added.size());
    std::move(added.begin(), added.end(), std::back_inserter(records));
    done_.pop_back();
    done_.back().operation = std::move(operation);
    ++revision_;
}

void History::move(std::vector<Edit>& from, std::vector<Edit>& to) noexcept {
    to.push_back(std::move(from.back()));
    from.pop_back();
    keepToLimit();
}

void History::forget(std::vector<Edit>& edits) noexcept {
    for (const Edit& edit : edits) {
        if (edit.spilled) {
            file_.release(*edit.spilled);
        }
    }
    edits.clear();
}

std::optional<std::uint64_t> History::contentBeforeLast() const {
    const auto cut =
        std::find_if(done_.rbegin() + 1, done_.rend(), [](const Edit& edit) { return edit.cut.has_value(); });
    return cut == done_.rend() ? std::optional<std::uint64_t>(0) : cut->cutContent;
}

Edit& History::inMemory(Edit& edit) {
    if (edit.spilled) {
        edit.cut->giveBack(file_.read(*edit.spilled));
        file_.release(*std::exchange(edit.spilled, std::nullopt));
    }
    return edit;
}

void History::keepToLimit() noexcept {
    ++revision_; // each change of the edits ends here
    try {
        spillWhatIsTooMuch();
        hasComplained_ = false;
    } catch (const std::exception& error) { // nothing is lost: it stays in memory
        if (!std::exchange(hasComplained_, true)) {
            logNotice(error.what());
        }
    }
}

// What is farthest from being needed goes first: the oldest to undo, then the newest to redo.
void History::spillWhatIsTooMuch() {
    std::size_t bytes = bytesInMemory(done_) + bytesInMemory(undone_);
    for (std::vector<Edit>* edits : {&done_, &undone_}) {
        for (auto edit = edits->begin(); edit != edits->end() && bytes > memoryLimit_; ++edit) {
            if (edit->cut && !edit->spilled && !edit->cut->held().empty()) {
                const std::size_t size = edit->cut->held().size();
                spill(*edit);
                bytes -= size;
            }
        }
    }
}

std::vector<std::byte> History::heldBy(const Edit& edit) const {
    if (edit.spilled) {
        return file_.read(*edit.spilled);
    }
    const auto held = edit.cut ? edit.cut->held() : std::span<const std::byte>();
    return {held.begin(), held.end()};
}

void History::restore(std::vector<Edit> done, std::vector<Edit> undone) {
    VS_CHECK(done_.empty() && undone_.empty());
    done_ = std::move(done);
    undone_ = std::move(undone);
    keepToLimit();
}

void History::spill(Edit& edit) {
    edit.spilled = file_.write(edit.cut->held());
    edit.cut->drop();
}

UndoStatistics History::statistics() const {
    UndoStatistics all;
    all.steps = done_.size() + undone_.size();
    all.bytesInMemory = bytesInMemory(done_) + bytesInMemory(undone_);
    all.bytesInFile = file_.bytesInUse();
    all.fileBytes = file_.fileBytes();
    for (const auto* edits : {&done_, &undone_}) {
        for (const Edit& edit : *edits) {
            all.changedVoxels += edit.cut ? edit.cut->changedVoxels() : 0;
            all.bytesInMemory += edit.cut ? edit.cut->finer.memoryBytes() : 0;
        }
    }
    return all;
}

} // namespace vs::studio
