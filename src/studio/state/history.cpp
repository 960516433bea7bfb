// SPDX-License-Identifier: Apache-2.0
#include "studio/state/history.h"

#include "base/check.h"
#include "base/error.h"
#include "base/log.h"

#include <utility>

namespace vs::studio {

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

void History::renameLast(Operation operation) {
    done_.back().operation = std::make_shared<const Operation>(std::move(operation));
    ++revision_;
}

void History::push(Edit edit) {
    forget(undone_);
    done_.push_back(std::move(edit));
    keepToLimit();
}

void History::mergeLastTwo() {
    Edit last = std::move(done_.back());
    done_.pop_back();
    for (auto& record : last.growth) {
        done_.back().growth.push_back(std::move(record));
    }
    ++revision_;
}

void History::move(std::vector<Edit>& from, std::vector<Edit>& to) {
    to.push_back(std::move(from.back()));
    from.pop_back();
    keepToLimit();
}

void History::forget(std::vector<Edit>& edits) {
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

// What is farthest from being needed goes first: the oldest to undo, then the newest to redo.
void History::keepToLimit() {
    ++revision_; // each change of the edits ends here
    std::size_t bytes = bytesInMemory(done_) + bytesInMemory(undone_);
    try {
        for (std::vector<Edit>* edits : {&done_, &undone_}) {
            for (auto edit = edits->begin(); edit != edits->end() && bytes > memoryLimit_; ++edit) {
                if (edit->cut && !edit->spilled && !edit->cut->held().empty()) {
                    const std::size_t size = edit->cut->held().size();
                    spill(*edit);
                    bytes -= size;
                }
            }
        }
        hasComplained_ = false;
    } catch (const WriteError& error) { // nothing is lost: it stays in memory
        if (!std::exchange(hasComplained_, true)) {
            logNotice(error.what());
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
        }
    }
    return all;
}

} // namespace vs::studio
