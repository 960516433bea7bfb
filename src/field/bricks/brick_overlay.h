// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_grid.h"
#include "gl/texture.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace vs::field {

// What may lie over the bricks of a scan, each in a texture of its own.
enum class BrickLayer { Cuts, Segments };
inline constexpr std::array kBrickLayers{BrickLayer::Cuts, BrickLayer::Segments};
template <typename T>
using OfBrickLayers = std::array<T, kBrickLayers.size()>;
using LayerFormats = OfBrickLayers<std::optional<gl::Format>>; // nothing: it has no texture

// A layer of what is known at the finest level of a scan, and is looked up where its values are: what was cut
// away there, or how much belongs to segments. It never changes; another one takes its place.
class BrickOverlay {
public:
    virtual ~BrickOverlay() = default;
    // Channels from 0 to 1: one for cuts; for segments RG8, how much belongs to them and a label / 255, or
    // RGBA8, opaque ones, translucent ones, label.
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
