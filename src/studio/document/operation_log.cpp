// SPDX-License-Identifier: Apache-2.0
#include "studio/document/operation_log.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <type_traits>
#include <utility>

namespace vs::studio {

static_assert(std::is_nothrow_move_constructible_v<Operation> && std::is_nothrow_move_assignable_v<View>);

OperationLog::Entry OperationLog::prepare(Operation operation, const View& before, const View& after) {
    Entry entry{{}, after};
    entry.operations.reserve(2);
    if (shown_ != before && !std::holds_alternative<SetView>(operation)) {
        entry.operations.emplace_back(setViewTo(before));
    }
    entry.operations.push_back(std::move(operation));
    const std::size_t most = operations_.size() + entry.operations.size();
    if (operations_.capacity() < most) {
        operations_.reserve(2 * most);
    }
    return entry;
}

void OperationLog::add(Entry entry) noexcept {
    std::move(entry.operations.begin(), entry.operations.end(), std::back_inserter(operations_));
    shown_ = std::move(entry.after);
}

void OperationLog::placesAre(const std::vector<render::Placement>& places) noexcept {
    try {
        if (shown_) {
            shown_->pasted = places;
        }
    } catch (const std::bad_alloc&) {
        shown_.reset();
    }
}

Operation OperationLog::takeLast() {
    Operation last = std::move(operations_.back());
    operations_.pop_back();
    return last;
}

} // namespace vs::studio
