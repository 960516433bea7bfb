// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vs::studio {

// All operations on a document, in order: what a session saves. The view is logged when something is done in
// it, not whenever it changes.
class OperationLog {
public:
    // The view that a document begins with.
    explicit OperationLog(View view) : shown_(std::move(view)) {}
    // The log of a document that was kept in a file, with the view that it shows.
    OperationLog(View view, std::vector<Operation> operations)
        : operations_(std::move(operations)), sealed_(operations_.size()), shown_(std::move(view)) {}

    [[nodiscard]] const std::vector<Operation>& operations() const { return operations_; }

    // What is about to be appended, with all that needs memory for it.
    struct Entry {
        std::vector<Operation> operations; // the view first, where that has to be told
        View after;
    };
    // Makes ready to append an operation that is done in the view `before` and leaves the view `after`.
    Entry prepare(Operation operation, const View& before, const View& after);
    void add(Entry entry) noexcept;

    // Appends an operation that was done in the view `before` and left the view `after`, or throws and
    // changes nothing.
    void record(Operation operation, const View& before, const View& after) {
        add(prepare(std::move(operation), before, after));
    }
    // Appends an operation that leaves the view as it is.
    void record(Operation operation, const View& view) { record(std::move(operation), view, view); }

    // A file holds what is logged so far: what comes is not merged with it any more.
    void seal() { sealed_ = operations_.size(); }
    // The last operation is not sealed, and the view has not changed since: what comes may be merged with it.
    [[nodiscard]] bool canMerge(const View& view) const {
        return operations_.size() > sealed_ && shown_ == view;
    }
    [[nodiscard]] Operation& last() { return operations_.back(); }
    // Takes the last operation out of the log.
    Operation takeLast();
    // The last edit, before it is replaced, was taken back, and pasted parts are in their places of before:
    // the view has changed, but nobody has looked around.
    void placesAre(const std::vector<render::Placement>& places) noexcept;

private:
    std::vector<Operation> operations_;
    std::size_t sealed_ = 0; // so many operations are never replaced
    // What replaying the log would show; nothing: it is not known, and the view is told with what comes next.
    std::optional<View> shown_;
};

} // namespace vs::studio
