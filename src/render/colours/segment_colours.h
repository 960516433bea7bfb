// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/block_layout.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>

namespace vs::render {

// How segments look, by label: linear light (rgb) and opacity (a): 1 opaque, between 0 and 1 translucent, 0
// hidden. field::Scene::segmentation has to agree: opaque segments in its red channel, translucent ones in
// green, hidden ones in neither. Entry 0 colours what is segmented and has no label.
struct SegmentColours {
    // All opaque, near the vermilion of the Okabe-Ito palette.
    SegmentColours() { entries.fill({0.70F, 0.17F, 0.04F, 1.0F}); }

    // Whether some segment is translucent: drawing those takes time.
    [[nodiscard]] bool haveTranslucent() const {
        return std::any_of(entries.begin() + 1, entries.end(),
                           [](const glm::vec4& entry) { return entry.a > 0.0F && entry.a < 1.0F; });
    }

    std::array<glm::vec4, 256> entries;
};
// They are written into SegmentColoursBlock of render/shaders/segment_colours.glsl (std140).
inline constexpr gl::BlockMember kSegmentColoursBlockMembers[] = {VS_BLOCK_MEMBER(SegmentColours, entries)};
inline constexpr gl::BlockLayout kSegmentColoursBlockLayout{"SegmentColoursBlock", sizeof(SegmentColours),
                                                            kSegmentColoursBlockMembers};
static_assert(isWhole(kSegmentColoursBlockLayout));

} // namespace vs::render
