// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vs::segment {

// Undoes one call that changed a Growth, restoring its seed map byte for byte and its state. Made by passing
// it to the call; redo is calling again. What advancing added is not kept, since erasing it needs only its
// number; erased generations are kept as compressed bricks.
class GrowthUndo {
public:
    // The growth must be as the call left it, apart from where its playhead stands. The sculpture that the
    // earlier constraints name must still exist.
    void undo(Growth& growth) const;

    // The recorded call was Growth::advance(), and advancing went on in further calls without records of
    // their own: this one now undoes them all.
    void continueTo(const Growth& growth) { end(growth); }

    // Memory taken by this record.
    [[nodiscard]] std::size_t bytes() const;

private:
    friend class Growth;

    struct SavedBrick {
        std::uint32_t brick = 0;
        GenerationSpan span;
        std::vector<std::byte> compressed;
    };

    void begin(const Growth& growth);
    // Saves the bricks that hold generations after `last`, as they are.
    void save(const Growth& growth, int last);
    void end(const Growth& growth) { extentAfter_ = growth.extent(); }

    GrowthState before_;
    int extentAfter_ = 0;
    std::vector<std::uint32_t> addedSeeds_;
    std::vector<SavedBrick> saved_;
};

} // namespace vs::segment
