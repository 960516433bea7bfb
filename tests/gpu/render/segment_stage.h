// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/render/stage.h"
#include "phantom/phantom.h"
#include "render/colours/colour.h"

#include <algorithm>

namespace vs::test {

inline constexpr glm::ivec2 kSize{160, 128};
inline constexpr glm::dvec3 kCentre(23.5);
inline constexpr double kOuter = 17;
inline constexpr double kInner = 8;
inline constexpr render::Mode kModesWithSegments[] = {render::Mode::Overlay, render::Mode::Segment};

inline glm::vec4 entry(render::Colour colour, float opacity = 1) {
    return {glm::vec3(render::linearFromColour(colour)), opacity};
}

inline const glm::vec4 kRed = entry({220, 60, 50});
inline const glm::vec4 kBlue = entry({50, 110, 220});

inline double membership(glm::dvec3 p, glm::dvec3 centre, double radius) {
    return std::clamp(0.5 + (radius - glm::length(p - centre)) / 4, 0.0, 1.0);
}

inline double nothing(glm::dvec3) { return 0; }

// A grid that shows nothing but its segments, on black: its values are below the displayed range.
struct SegmentStage : Stage {
    explicit SegmentStage(const VoxelFunction& value = nothing)
        : Stage(phantom::makePhantom({48, 48, 48}, volume::ScalarType::UInt8, value), {100, 255}) {
        darken();
        look({30, 20, 1.2, {}, render::Projection::Orthographic}, kSize);
    }

    void colour(int segment, const glm::vec4& entry) {
        frame.segmentColours.entries[std::size_t(segment)] = entry;
    }

    // The picture with all segments of one colour.
    image::Image pictureIn(const glm::vec4& entry, render::Mode mode) {
        const auto before = frame.segmentColours;
        frame.segmentColours.entries.fill(entry);
        auto result = picture(mode);
        frame.segmentColours = before;
        return result;
    }

    // A translucent ball, segment 1, around an opaque one, segment 2.
    void nest(const glm::vec4& outer, const glm::vec4& inner) {
        const auto ball = [](double radius) {
            return [=](glm::dvec3 p) { return membership(p, kCentre, radius); };
        };
        colour(1, outer);
        colour(2, inner);
        segments(ball(kInner), ball(kOuter),
                 [](glm::dvec3 p) { return glm::length(p - kCentre) <= kInner ? 2 : 1; });
    }
};

} // namespace vs::test
