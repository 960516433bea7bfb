// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <optional>
#include <vector>

namespace vs::studio {

// What a pen drew for an operation, in pixels of its canvas.
struct Drawn {
    using Line = std::vector<glm::dvec2>;

    std::vector<Line> areas =
        {}; // closed outlines, filled by the even-odd rule: masks, seeds that are filled
    std::vector<Line> lines = {}; // open ones, `lineWidth` pixels wide: seeds
    Line way = {};                // along which the pen carried the area; empty: it stayed where it was drawn
    double lineWidth = 0;         // pixels
    std::optional<Canvas> canvas = {}; // not set: the view at that moment, on a viewport of 1230 x 870

    [[nodiscard]] bool isEmpty() const { return areas.empty() && lines.empty() && way.empty(); }
    // The area when its centre is at a place of the way.
    [[nodiscard]] Line areaAt(const Line& area, glm::dvec2 place) const;
};

// Nothing for operations that are not drawn: empty.
Drawn drawnFor(const Operation& operation);

} // namespace vs::studio
