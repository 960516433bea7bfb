// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth.h"

#include <cstddef>
#include <cstdint>
#include <optional>
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
        std::size_t size = 0; // uncompressed
        std::vector<std::byte> compressed;
    };

    void begin(const Growth& growth);
    // Saves bricks as they are.
    void save(const Growth& growth, const std::vector<std::uint32_t>& bricks);
    // Saves what is forbidden.
    void keepForbidden(const Growth& growth);
    void end(const Growth& growth);

    std::uint8_t labelBefore_ = 0;
    std::uint8_t labelAfter_ = 0;
    GrowthState before_;
    int extentAfter_ = 0;
    std::vector<std::uint32_t> addedSeeds_;
    std::vector<std::uint32_t> allowedAgain_; // those of them that were forbidden
    std::vector<SavedBrick> saved_;           // in the order in which they were changed
    // Whether the call changed what is forbidden, and the plane before it (compressed; empty: nothing was).
    bool changesForbidden_ = false;
    std::vector<std::byte> forbidden_;
};

} // namespace vs::segment
