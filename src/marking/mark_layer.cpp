// SPDX-License-Identifier: Apache-2.0
#include "marking/mark_layer.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace vs::marking {

namespace {

constexpr double kAll = 255;

// How much of a texel lies within an edge that passes it or its neighbours.
double insideOf(std::uint8_t coverage) {
    return std::clamp((coverage / kAll - 0.5) * field::kMarkRamp + 0.5, 0.0, 1.0);
}

std::uint8_t byteOf(double part) { return std::uint8_t(std::lround(std::clamp(part, 0.0, 1.0) * kAll)); }

field::MarkTexel erased(field::MarkTexel texel, std::uint8_t coverage, std::uint8_t opacity) {
    if (opacity == 255) {
        texel.coverage = std::min(texel.coverage, std::uint8_t(255 - coverage));
    } else { // what is left of it is paler
        texel.opacity = byteOf(texel.opacity / kAll * (1 - insideOf(coverage) * opacity / kAll));
    }
    return texel.coverage == 0 || texel.opacity == 0 ? field::MarkTexel() : texel;
}

} // namespace

field::MarkTexel inked(const field::MarkTexel& texel, std::uint8_t coverage, std::uint8_t opacity,
                       const Ink& ink) {
    if (coverage == 0 || opacity == 0) {
        return texel;
    }
    if (ink.erases) {
        return erased(texel, coverage, opacity);
    }
    const field::MarkTexel pure{ink.colour[0], ink.colour[1], ink.colour[2], opacity, coverage};
    const double inside = insideOf(coverage);
    const double wasInside = insideOf(texel.coverage);
    const bool isPure = wasInside == 0 && (inside > 0 || coverage >= texel.coverage);
    const bool isAsBefore = inside == 0 && !isPure;
    field::MarkTexel result = isPure ? pure : texel;
    if (!isPure && !isAsBefore) {
        const double over = inside * opacity / kAll;
        const double under = texel.opacity / kAll * (1 - over);
        const double both = over + under;
        const auto mixed = [&](std::uint8_t now, std::uint8_t before) {
            return byteOf((over * now + under * before) / both / kAll);
        };
        result.red = mixed(pure.red, texel.red);
        result.green = mixed(pure.green, texel.green);
        result.blue = mixed(pure.blue, texel.blue);
        result.opacity = byteOf(both);
    }
    result.coverage = std::max(texel.coverage, coverage);
    return result;
}

void MarkLayer::cover(glm::ivec3 texel, double coverage, double opacity) {
    const std::uint32_t place = grid_.placeOf(texel / field::kMarkBrick);
    if (last_ == nullptr || place != lastPlace_) {
        last_ = &bricks_[place];
        lastPlace_ = place;
    }
    Covered& held = (*last_)[field::MarkBrick::index(texel % field::kMarkBrick)];
    const Covered raised{std::max(held.coverage, byteOf(coverage)), std::max(held.opacity, byteOf(opacity))};
    if (raised.coverage != held.coverage || raised.opacity != held.opacity) {
        held = raised;
        touched_.insert(place);
    }
}

field::Marks MarkLayer::on(const field::Marks& before, const field::Marks& now, const Ink& ink) {
    std::vector<field::Marks::Entry> changed;
    for (const std::uint32_t place : touched_) {
        const Brick& layer = bricks_.at(place);
        const field::MarkBrick* under = before.find(place);
        auto brick = under != nullptr ? std::make_shared<field::MarkBrick>(*under)
                                      : std::make_shared<field::MarkBrick>();
        for (std::size_t i = 0; i < layer.size(); ++i) {
            if (layer[i].coverage != 0) {
                brick->set(i, inked(brick->at(i), layer[i].coverage, layer[i].opacity, ink));
            }
        }
        changed.emplace_back(place, std::move(brick));
    }
    touched_.clear();
    const field::Marks onGrid = now.isEmpty() ? field::Marks(grid_, {}) : now;
    return onGrid.with(std::move(changed));
}

} // namespace vs::marking
