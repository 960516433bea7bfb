// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/finer/fine_growth.h"
#include "segment/growth/growth_undo.h"

#include <cstddef>
#include <memory>

namespace vs::studio {

// Undoes one change of a document's segments: of those of the level that is worked on, or, where they grow at
// a finer one, of those.
struct RegionUndo {
    segment::GrowthUndo scene;
    std::shared_ptr<segment::FineUndo> finest = {}; // null: of the scene's

    // Memory taken by it.
    [[nodiscard]] std::size_t bytes() const {
        return scene.bytes() + (finest == nullptr ? 0 : finest->bytes());
    }
};

} // namespace vs::studio
