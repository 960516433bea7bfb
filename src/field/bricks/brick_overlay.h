// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "gl/texture.h"

#include <cstddef>
#include <vector>

namespace vs::field {

// A scalar that lies over the finest level of a scan and is looked up where its values are: what was cut away
// there. It never changes; another one takes its place.
class BrickOverlay {
public:
    virtual ~BrickOverlay() = default;
    // One channel, 0 to 1.
    [[nodiscard]] virtual gl::Format format() const = 0;
    [[nodiscard]] virtual bool isEmpty() const = 0;
    // Its texels for a brick of a level, BrickGrid::texels()^3, x fastest; none: all are zero.
    [[nodiscard]] virtual std::vector<std::byte> texelsOf(const BrickGrid& level, glm::ivec3 brick) const = 0;
    // Whether another one, of the same scan at another time, gives the same for such a brick; false where
    // that is not known at once.
    [[nodiscard]] virtual bool isAlike(const BrickOverlay& other, const BrickGrid& level,
                                       glm::ivec3 brick) const = 0;
};

} // namespace vs::field
