// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/document/document_state.h"

namespace vs::studio {

// Private to the document's own files.
template <typename Op>
auto Document::Impl::change(const Op& op) {
    Region::Records records;
    const SegmentList before = segments;
    const auto keep = [&] {
        history.push({op, {}, std::move(records)});
        if (!(segments == before)) {
            history.last().segmentsBefore = before;
            history.last().segmentsAfter = segments;
        }
        ++version;
    };
    try {
        if constexpr (std::is_void_v<decltype(perform(op, records))>) {
            perform(op, records);
            keep();
        } else {
            auto result = perform(op, records);
            keep();
            return result;
        }
    } catch (...) {
        region.undo(records);
        segments = before;
        throw;
    }
}

} // namespace vs::studio
