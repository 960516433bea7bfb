// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "render/colours/segment_colours.h"
#include "render/slices/slice_view.h"
#include "volume/grid/volume.h"

#include <vector>

namespace vs::reference {

// A picture of a slice, voxel by voxel: what render::SliceRenderer draws of values in grey and of opaque
// segments, with nothing cut. Plain: no outlines (their width is 0).
struct SliceScene {
    const volume::Volume* volume = nullptr;
    Range window;                  // from black to white
    std::vector<float> membership; // one a voxel, 0 to 1; empty: no segments
    std::vector<std::uint8_t> labels;
    render::SegmentColours colours;
    bool isSmooth = true;
    double fill = 0.4;
};
image::Image drawSlice(const SliceScene& scene, const render::SliceView& view);

} // namespace vs::reference
