// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/stroke_raster.h"

#include <cmath>

namespace vs::studio {

StrokeRaster::Element& StrokeRaster::at(glm::ivec2 e) {
    static_assert((kChunk & (kChunk - 1)) == 0);
    const glm::ivec2 place((e.x & ~(kChunk - 1)), (e.y & ~(kChunk - 1)));
    if (last_ == nullptr || place != lastPlace_) {
        last_ = &chunks_[{place.x, place.y}];
        lastPlace_ = place;
    }
    const glm::ivec2 within = e - place;
    return last_->elements[std::size_t(within.y) * kChunk + std::size_t(within.x)];
}

bool StrokeRaster::cover(glm::ivec2 e, float covered, float depth, glm::vec3 direction) {
    Element& element = at(e);
    bool isChanged = false;
    if (covered > element.mask) {
        element.mask = covered;
        isChanged = true;
    }
    float& deepest = covered >= 0.5F ? element.core : element.fringe;
    if (depth > deepest) {
        const bool counts = covered >= 0.5F || element.core <= 0;
        deepest = depth;
        element.direction = counts ? direction : element.direction;
        isChanged = isChanged || counts;
    }
    return isChanged;
}

ElementBox StrokeRaster::cover(const sculpt::MaskRaster& mask, const Place& from, const Place& to) {
    ElementBox changed{glm::ivec2(1 << 30), glm::ivec2(-(1 << 30))};
    const auto value = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < mask.size.x && j < mask.size.y ? mask.at(i, j) : 0.0F;
    };
    // A quarter of an element apart, steps in the mask's edge (two elements wide) and in the floor are below
    // 0.01.
    const int places = 2 + int(std::ceil(4 * glm::length(to.pixel - from.pixel) / pitch_)); // both ends
    for (int n = 0; n < places; ++n) {
        const double s = double(n) / (places - 1);
        const auto depth = float(glm::mix(from.depth, to.depth, s));
        if (!(depth > 0)) {
            continue;
        }
        const glm::vec3 direction(glm::normalize(glm::mix(from.direction, to.direction, s)));
        const glm::dvec2 shift = (glm::mix(from.pixel, to.pixel, s) + mask.origin) / pitch_;
        const glm::ivec2 whole(glm::floor(shift));
        const glm::vec2 f(shift - glm::dvec2(whole));
        for (int j = 0; j <= mask.size.y; ++j) {
            for (int i = 0; i <= mask.size.x; ++i) {
                const float covered = glm::mix(glm::mix(value(i, j), value(i - 1, j), f.x),
                                               glm::mix(value(i, j - 1), value(i - 1, j - 1), f.x), f.y);
                const glm::ivec2 e = whole + glm::ivec2(i, j);
                if (covered > 0 && cover(e, covered, depth, direction)) {
                    changed.lo = glm::min(changed.lo, e);
                    changed.hi = glm::max(changed.hi, e + 1);
                }
            }
        }
    }
    return changed;
}

void StrokeRaster::lookUnder(const ElementBox& box, const Pick& pick) {
    std::vector<glm::vec2> pixels;
    std::vector<Element*> unknown;
    for (int y = box.lo.y - 1; y <= box.hi.y; ++y) {
        for (int x = box.lo.x - 1; x <= box.hi.x; ++x) {
            Element& element = at({x, y});
            if (!element.isPicked) {
                pixels.emplace_back(pitch_ * glm::dvec2(x, y));
                unknown.push_back(&element);
            }
        }
    }
    const auto points = pick(pixels);
    for (std::size_t n = 0; n < unknown.size(); ++n) {
        unknown[n]->surface = points[n];
        unknown[n]->isPicked = true;
    }
}

StrokeRaster::Part StrokeRaster::part(const ElementBox& box) {
    Part part;
    part.mask.pitch = pitch_;
    part.mask.size = box.size();
    part.mask.origin = pitch_ * glm::dvec2(box.lo);
    const std::size_t count = std::size_t(part.mask.size.x) * std::size_t(part.mask.size.y);
    part.mask.values.reserve(count);
    for (int y = box.lo.y; y < box.hi.y; ++y) {
        for (int x = box.lo.x; x < box.hi.x; ++x) {
            const Element& element = at({x, y});
            part.mask.values.push_back(element.mask);
            part.depths.push_back(element.core > 0 ? element.core : element.fringe);
            part.directions.push_back(element.direction);
            part.surface.push_back(element.surface);
        }
    }
    return part;
}

} // namespace vs::studio
