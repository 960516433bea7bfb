// SPDX-License-Identifier: Apache-2.0
// What is wrong with operations whose members are right one by one.
#include "marking/pen_letters.h"
#include "studio/operations/filling.h"
#include "studio/operations/housekeeping.h"
#include "studio/operations/marking.h"
#include "studio/operations/measuring.h"
#include "studio/operations/sweeping.h"
#include "volume/measures/figures.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>

namespace vs::studio {

Fault faultOfSize(const char* member, glm::ivec2 size, int mostPixels) {
    const auto pixels = std::int64_t(size.x) * size.y;
    if (pixels <= mostPixels) {
        return {};
    }
    return {member,
            fmt::format("{} x {} are {} pixels; there may be {}", size.x, size.y, pixels, mostPixels)};
}

Fault Canvas::faultOf() const { return faultOfSize("viewport", viewport, kMostCanvasPixels); }

Fault SavePicture::faultOf() const { return faultOfSize("size", size, kMostPixels); }

Fault SweepPath::faultOf() const {
    if (kind == Kind::Standing && points[0] == points[1]) {
        return {"points", "the mask must face another place than it stands on"};
    }
    return {};
}

Fault Clip::faultOf() const {
    if (box && glm::any(glm::greaterThan(box->lo, box->hi))) {
        return {"box", "its first corner must not lie above its second along any axis"};
    }
    return {};
}

namespace {
template <typename Stroke>
Fault faultOfFill(const Stroke& stroke) {
    const bool restores = std::visit([](const auto& op) { return op.restores; }, stroke);
    return restores ? Fault{"stroke", "a stroke that restores neither fills nor takes away what is filled"}
                    : Fault();
}
} // namespace

Fault Fill::faultOf() const { return faultOfFill(stroke); }
Fault Unfill::faultOf() const { return faultOfFill(stroke); }

Fault Mark::faultOf() const {
    if (!pressures.empty() && pressures.size() != sketch.points.size()) {
        return {"pressures", fmt::format("there are {} for {} points; one for each is needed, or none",
                                         pressures.size(), sketch.points.size())};
    }
    if (kind == Kind::Arrow && (sketch.isInBox() || sketch.points.size() < 2)) {
        return {"sketch", "an arrow goes along a free-form line or a polyline of at least two points"};
    }
    if (kind == Kind::Text && sketch.points.empty()) {
        return {"sketch", "letters need a place to stand"};
    }
    if (const std::string character = marking::unwritable(text); !character.empty()) {
        return {"text",
                fmt::format("a pen does not write \"{}\": it writes A to Z, umlauts, digits, ° and + - × = / "
                            ". , : ? ! * < > ( )",
                            character)};
    }
    return {};
}

Fault Measure::faultOf() const {
    struct Count {
        std::size_t least;
        std::size_t most;
        const char* wanted;
    };
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    constexpr std::array<Count, kKinds.size()> counts{
        {{2, 2, "two points are needed for a distance"},
         {3, 3, "three points are needed for an angle"},
         {2, any, "at least two points are needed for a path"},
         {3, any, "at least three points are needed for an area"},
         {2, 2, "two points are needed for a vessel: the ends of what is measured"},
         {0, 0, "a cut is measured without points"}}};
    const Count& count = counts[std::size_t(kind)];
    if (points.size() < count.least || points.size() > count.most) {
        return {"points", count.wanted};
    }
    if (centreline.size() != diametersMm.size()) {
        return {"diameters", "must be as many as the centreline has points"};
    }
    if (kind == Kind::Area && volume::sliceAxis(points) < 0) {
        return {"points", "all points of an area must have the same first, second or third coordinate: they "
                          "must lie in one slice"};
    }
    return {};
}

Fault Clip::Plane::faultOf() const {
    if (glm::length(normal) < 1e-9) {
        return {"", "its normal must have a length"};
    }
    return {};
}

} // namespace vs::studio
