// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "render/camera/placement.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vs::studio {

class Display;
struct Contents;

// A part of the picture besides what remains, where it is drawn at the moment.
struct SeenPart {
    std::size_t at = 0; // a pasted part's place in the view; the label of a segment that is pulled out
    std::string name;
    render::Placement place;
};

// The labels of segments that are seen pulled out.
std::vector<std::uint8_t> labelsOf(const std::vector<SeenPart>& pulledOut);

// Where pasted parts, and what remains of the volume, can be seen. Parts are counted from 0 in the order in
// which they were pasted; the view's places may be more or fewer.
class PartQueries {
public:
    // Both must outlive it.
    PartQueries(const Contents& contents, Display& display) : contents_(contents), display_(display) {}

    [[nodiscard]] std::size_t count() const;
    // Voxels around what can be seen of a pasted part, where it was cut out; empty when that is nothing. And
    // around what the next paste would take, what tools cut since the last one.
    Box3 box(std::size_t part);
    Box3 nextBox(bool takesTrimmed = false);
    // The middles (voxel space) of the macrocells in which something of such a part can be seen; and of those
    // in which something of what remains can, as the view shows the sculpture.
    std::vector<glm::dvec3> cells(std::size_t part);
    std::vector<glm::dvec3> nextCells(bool takesTrimmed = false);
    std::vector<glm::dvec3> remainingCells();
    // Boxes and macrocells likewise, around the voxels of segments, by label. Takes a while: it looks at all
    // voxels, once for all segments.
    std::array<Box3, 256> segmentBoxes();
    std::map<std::uint8_t, std::vector<glm::dvec3>> segmentCells(const std::vector<std::uint8_t>& labels);
    // The pasted parts that are not hidden, and the segments that are seen pulled out.
    [[nodiscard]] std::vector<SeenPart> seen() const;
    [[nodiscard]] std::vector<SeenPart> seenPulledOut() const;
    // Where a part or segment with this box has to be put to be drawn there, as the view spreads parts.
    [[nodiscard]] render::Placement putFor(const render::Placement& drawn, const Box3& box) const;
    // Points of the world around all that the picture of the present view shows, in any mode: what remains,
    // segments, also those that are pulled out, and pasted parts. Specks, as noise in the air leaves them,
    // are not counted. Around the whole grid when nothing can be seen. Nothing seen lies outside of the
    // points' convex hull.
    std::vector<glm::dvec3> pointsAroundAll();
    // What is drawn at a place of the view, x fastest in the box: the part where it is at least a half.
    std::vector<float> values(std::size_t place, const Box3& box);

private:
    std::vector<Box3> rowsSeen();
    void addPlaced(const std::vector<glm::dvec3>& cells, const render::Placement& place,
                   std::vector<glm::dvec3>& points) const;

    const Contents& contents_;
    Display& display_;
};

} // namespace vs::studio
