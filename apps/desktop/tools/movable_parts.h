// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/placement.h"
#include "studio/operations/operation.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::desktop {

class StudioController;

// What a person can move about the picture: pasted parts, and after them the segments that are pulled out and
// can be seen. Counted from 0.
class MovableParts {
public:
    explicit MovableParts(StudioController& studio) : studio_(studio) {}

    [[nodiscard]] int count() const;
    // The number of a segment that is pulled out.
    [[nodiscard]] std::optional<int> numberOf(const std::string& segment) const;
    // The segment with that number; nothing for a pasted part.
    [[nodiscard]] std::optional<std::string> segment(int part) const;
    // Where a part is shown at the moment.
    [[nodiscard]] render::Placement place(int part) const;
    // Voxels around a part, where it was cut out or lies; empty when nothing of it can be seen.
    [[nodiscard]] Box3 box(int part) const;

    // Looks for the boxes again if an edit may have changed them; may take long.
    void find();
    void forget() { boxes_.clear(); }

    // Shows a part elsewhere until show() is called for it with where it was, and the operation that moves
    // it.
    void show(int part, const render::Placement& place);
    [[nodiscard]] studio::Operation moved(int part, const render::Placement& place) const;

private:
    [[nodiscard]] int pasted() const;
    [[nodiscard]] std::vector<studio::SegmentInfo> pulledOut() const;

    StudioController& studio_;
    std::vector<Box3> boxes_;
    std::size_t seenEdits_ = 0; // operations in the log when they were looked for
};

} // namespace vs::desktop
