// SPDX-License-Identifier: Apache-2.0
#include "studio/strokes/stroke_raster.h"

#include <algorithm>
#include <cmath>

namespace vs::studio {

namespace {

// A mask on its straight way between two places, as one element of the raster after the other sees it pass.
class MaskWay {
public:
    MaskWay(const sculpt::MaskRaster& mask, const std::vector<std::uint16_t>& flat,
            const StrokeRaster::Place& from, const StrokeRaster::Place& to, double pitch)
        : mask_(mask), flat_(flat) {
        // A quarter of an element apart, steps in the mask's edge (two elements wide) and in the floor are
        // below 0.01.
        const int places = 2 + int(std::ceil(4 * glm::length(to.pixel - from.pixel) / pitch)); // both ends
        const glm::dvec2 apart = (to.pixel - from.pixel) / pitch / double(places - 1);
        apart_ = std::max({std::abs(apart.x), std::abs(apart.y), 1e-9});
        for (int n = 0; n < places; ++n) {
            const double s = double(n) / (places - 1);
            const glm::dvec2 shift = (glm::mix(from.pixel, to.pixel, s) + mask.origin) / pitch;
            const glm::ivec2 whole(glm::floor(shift));
            places_.push_back({whole, glm::vec2(shift - glm::dvec2(whole)),
                               float(glm::mix(from.depth, to.depth, s)),
                               glm::vec3(glm::normalize(glm::mix(from.direction, to.direction, s)))});
        }
    }

    // Those that it may pass.
    [[nodiscard]] ElementBox elements() const {
        const glm::ivec2 first = places_.front().whole;
        const glm::ivec2 last = places_.back().whole;
        return {glm::min(first, last), glm::max(first, last) + mask_.size + 1};
    }

    // Says what passes element `e`: how much of it is covered, how deep and which way. Of a stretch on which
    // the mask is the same it says the two ends, between which depths and directions lie.
    template <typename Pass>
    void follow(glm::ivec2 e, const Pass& pass) const {
        for (std::size_t n = 0;;) {
            const At& place = places_[n];
            const glm::ivec2 c = e - place.whole; // covered by elements c - 1 and c of the mask
            const float covered =
                glm::mix(glm::mix(value(c.x, c.y), value(c.x - 1, c.y), place.part.x),
                         glm::mix(value(c.x, c.y - 1), value(c.x - 1, c.y - 1), place.part.x), place.part.y);
            if (covered > 0 && place.depth > 0) {
                pass(covered, place.depth, place.direction);
            }
            if (n + 1 == places_.size()) {
                return;
            }
            // Two elements less: the mask's elements on either side, and what the place is off theirs.
            const double same = (flatAround(c) - 2) / apart_;
            n = same < 2 ? n + 1
                         : std::size_t(std::min(double(n) + std::floor(same), double(places_.size() - 1)));
        }
    }

private:
    struct At {
        glm::ivec2 whole;
        glm::vec2 part;
        float depth;
        glm::vec3 direction;
    };

    [[nodiscard]] float value(int i, int j) const {
        return i >= 0 && j >= 0 && i < mask_.size.x && j < mask_.size.y ? mask_.at(i, j) : 0.0F;
    }
    [[nodiscard]] int flatAround(glm::ivec2 c) const {
        const glm::ivec2 beyond = glm::max(glm::max(-c, c - mask_.size + 1), glm::ivec2(0));
        const int distance = std::max(beyond.x, beyond.y);
        return distance > 0 ? distance
                            : int(flat_[std::size_t(c.y) * std::size_t(mask_.size.x) + std::size_t(c.x)]);
    }

    const sculpt::MaskRaster& mask_;
    const std::vector<std::uint16_t>& flat_;
    std::vector<At> places_;
    double apart_ = 1; // two places, in elements, along the axis on which it is more
};

} // namespace

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

ElementBox StrokeRaster::cover(const sculpt::MaskRaster& mask, const std::vector<std::uint16_t>& flat,
                               const Place& from, const Place& to, const ElementBox& within) {
    ElementBox changed{glm::ivec2(1 << 30), glm::ivec2(-(1 << 30))};
    const MaskWay way(mask, flat, from, to, pitch_);
    const ElementBox box = way.elements();
    for (int y = std::max(box.lo.y, within.lo.y); y < std::min(box.hi.y, within.hi.y); ++y) {
        for (int x = std::max(box.lo.x, within.lo.x); x < std::min(box.hi.x, within.hi.x); ++x) {
            way.follow({x, y}, [&](float covered, float depth, const glm::vec3& direction) {
                if (cover({x, y}, covered, depth, direction)) {
                    changed.include({x, y});
                }
            });
        }
    }
    return changed;
}

ElementBox StrokeRaster::elementsIn(const sculpt::MaskWindow& pixels) const {
    if (pixels.isEmpty()) {
        return {};
    }
    constexpr double kFarthestElement = 1 << 29;
    const auto element = [&](const glm::dvec2& pixel) {
        return glm::ivec2(glm::clamp(glm::floor(pixel / pitch_), -kFarthestElement, kFarthestElement));
    };
    return {element(pixels.lo) - 1, element(pixels.hi) + 3};
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
