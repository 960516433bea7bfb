// SPDX-License-Identifier: Apache-2.0
#include "studio/document/operation_log.h"

#include <utility>

namespace vs::studio {

void OperationLog::record(Operation operation, const View& before, const View& after) {
    if (!(before == shown_) && !std::holds_alternative<SetView>(operation)) {
        operations_.emplace_back(setViewTo(before));
    }
    operations_.push_back(std::move(operation));
    shown_ = after;
}

Operation OperationLog::takeLast() {
    Operation last = std::move(operations_.back());
    operations_.pop_back();
    return last;
}

} // namespace vs::studio
