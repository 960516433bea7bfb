// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/growth/growth.h"
#include "segment/growth/saved_brick.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vs::segment {

// Undoes one call that changed a Growth, restoring its seed map byte for byte and its state. Made by passing
// it to the call; redo is calling again. A call that threw is undone likewise, however far it came: all that
// it needs is recorded before anything changes. What advancing added is not kept, since erasing it needs only
// its number; erased generations are kept as compressed bricks.
class GrowthUndo {
public:
    // The growth must be as the call left it, apart from where its playhead stands. The sculpture that the
    // earlier constraints name must still exist. When this throws for want of memory, it can be called again
    // and goes on where it stopped.
    void undo(Growth& growth) const;

    // The recorded call was Growth::advance(), and advancing went on in further calls without records of
    // their own: this one now undoes them all.
    void continueTo(const Growth& growth) noexcept { end(growth); }

    // Memory taken by this record.
    [[nodiscard]] std::size_t bytes() const;

    // All that it holds, for files.
    struct Content {
        std::uint8_t labelBefore = 0; // 0: the call never began
        std::uint8_t labelAfter = 0;
        GrowthState before;
        int extentAfter = 0;
        std::vector<std::uint32_t> addedSeeds;
        std::vector<std::uint32_t> allowedAgain; // those of them that were forbidden
        std::vector<SavedBrick> saved;           // in the order in which they were changed
        // Whether the call changed what is forbidden, and the plane before it (compressed; empty: nothing
        // was).
        bool changesForbidden = false;
        std::vector<std::byte> forbidden;
    };
    GrowthUndo() = default;
    explicit GrowthUndo(Content content) : held_(std::move(content)) {}
    [[nodiscard]] const Content& content() const { return held_; }

private:
    friend class Growth;
    class Recording;

    // Saves bricks as they are.
    void save(const Growth& growth, const std::vector<std::uint32_t>& bricks);
    // Saves what is forbidden.
    void keepForbidden(const Growth& growth);
    void eraseAdded(Growth& growth) const;
    void putBackErased(Growth& growth) const;
    void end(const Growth& growth) noexcept;

    Content held_;
    bool isInterrupted_ = false; // the call threw
};

// Records one call from its first line to its end, whichever way it ends. Without a record it does nothing.
class GrowthUndo::Recording {
public:
    Recording(GrowthUndo* undo, const Growth& growth);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

private:
    GrowthUndo* undo_;
    const Growth* growth_;
    int exceptionsBefore_;
};

} // namespace vs::segment
