// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/placement.h"
#include "studio/operations/operation.h"
#include "studio/operations/segment_list.h"

#include <optional>
#include <string>
#include <vector>

namespace vs::desktop {

class StudioController;

// What a person can move about the picture: the pasted parts that are not hidden, and after them the segments
// that are seen pulled out. Counted from 0.
class MovableParts {
public:
    explicit MovableParts(StudioController& studio) : studio_(studio) {}

    [[nodiscard]] int count() const;
    // The number of a segment that is pulled out, and of the part at a place of the view.
    [[nodiscard]] std::optional<int> numberOf(const std::string& segment) const;
    [[nodiscard]] std::optional<int> numberOf(std::size_t pasted) const;
    // Which one a number is of, whatever numbers parts have later; two that were pasted may be called the
    // same.
    struct Identity {
        bool isSegment = false;
        std::string name;
        bool operator==(const Identity&) const = default;
    };
    [[nodiscard]] std::optional<Identity> identityOf(int part) const;
    // The number that it has now: `before`, unless that is another's and it has one.
    [[nodiscard]] int numberOf(const Identity& identity, int before) const;
    // Where a part was put, or is in the hand at the moment; and where it is drawn then, as the view is
    // spread.
    [[nodiscard]] render::Placement put(int part) const;
    [[nodiscard]] render::Placement drawn(int part) const;
    // Voxels around a part, where it was cut out or lies; empty when nothing of it can be seen.
    [[nodiscard]] Box3 box(int part) const;

    // Looks for the parts and boxes again if an edit may have changed them; may take long.
    void find();
    void forget() { boxes_.clear(); }

    // Takes a part into the hand and draws it there, until it is let go: then it is where it was put before.
    void draw(int part, const render::Placement& there);
    void letGo(int part, const render::Placement& putBefore);
    // The operation that puts it there.
    [[nodiscard]] studio::Operation moved(int part, const render::Placement& put) const;

private:
    // A part at a place of the view, or a segment that is pulled out.
    struct Movable {
        std::size_t pasted = 0;
        std::optional<studio::SegmentInfo> segment;
        std::string name;
        glm::dvec3 middleVoxel{0}; // what the view's spread moves away
    };
    [[nodiscard]] std::vector<Movable> all() const;
    [[nodiscard]] Movable at(int part) const { return all()[std::size_t(part)]; }

    StudioController& studio_;
    std::vector<Box3> boxes_;
    std::size_t seenEdits_ = 0; // operations in the log when they were looked for
};

} // namespace vs::desktop
