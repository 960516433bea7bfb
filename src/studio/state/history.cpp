// SPDX-License-Identifier: Apache-2.0
#include "studio/state/history.h"

#include "base/error.h"
#include "base/log.h"

#include <utility>

namespace vs::studio {

namespace {

std::size_t bytesInMemory(const std::vector<Step>& steps) {
    std::size_t bytes = 0;
    for (const Step& step : steps) {
        bytes += step.cut ? step.cut->held().size() : 0;
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

void History::push(Step step) {
    forget(undone_);
    done_.push_back(std::move(step));
    keepToLimit();
}

void History::mergeLastTwo() {
    Step last = std::move(done_.back());
    done_.pop_back();
    for (auto& record : last.growth) {
        done_.back().growth.push_back(std::move(record));
    }
    ++revision_;
}

void History::move(std::vector<Step>& from, std::vector<Step>& to) {
    to.push_back(std::move(from.back()));
    from.pop_back();
    keepToLimit();
}

void History::forget(std::vector<Step>& steps) {
    for (const Step& step : steps) {
        if (step.spilled) {
            file_.release(*step.spilled);
        }
    }
    steps.clear();
}

Step& History::inMemory(Step& step) {
    if (step.spilled) {
        step.cut->giveBack(file_.read(*step.spilled));
        file_.release(*std::exchange(step.spilled, std::nullopt));
    }
    return step;
}

// What is farthest from being needed goes first: the oldest to undo, then the newest to redo.
void History::keepToLimit() {
    ++revision_; // each change of the steps ends here
    std::size_t bytes = bytesInMemory(done_) + bytesInMemory(undone_);
    try {
        for (std::vector<Step>* steps : {&done_, &undone_}) {
            for (auto step = steps->begin(); step != steps->end() && bytes > memoryLimit_; ++step) {
                if (step->cut && !step->spilled && !step->cut->held().empty()) {
                    const std::size_t size = step->cut->held().size();
                    spill(*step);
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

void History::spill(Step& step) {
    step.spilled = file_.write(step.cut->held());
    step.cut->drop();
}

UndoStatistics History::statistics() const {
    UndoStatistics all;
    all.steps = done_.size() + undone_.size();
    all.bytesInMemory = bytesInMemory(done_) + bytesInMemory(undone_);
    all.bytesInFile = file_.bytesInUse();
    all.fileBytes = file_.fileBytes();
    for (const auto* steps : {&done_, &undone_}) {
        for (const Step& step : *steps) {
            all.changedVoxels += step.cut ? step.cut->changedVoxels() : 0;
        }
    }
    return all;
}

} // namespace vs::studio
