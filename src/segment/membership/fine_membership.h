// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_overlay.h"
#include "field/scene.h"
#include "segment/finer/fine_front.h"
#include "segment/membership/segmentation.h"

#include <cstdint>
#include <memory>

namespace vs::segment {

class FineGrowth;

// What is shown of segments that have grown at the finest level, and how.
struct FineShown {
    Looks looks = allOpaque();
    Smoothing smoothing = Smoothing::Smooth;
    // What is cut away at the finest level hides segments in this view. Both null: nothing is cut.
    field::SculptureView view = field::SculptureView::Whole;
    FineFence fence = {};
    std::shared_ptr<const field::BrickOverlay> cuts = {};
};

// How much belongs to the segments of a growth as it is now, laid over bricks of any level: what Segmentation
// is for all of a scene, found brick by brick on the host. A voxel of a coarser level is in a segment where
// at least half of its finest voxels are, or any of them where no voxel around has so many. One channel for
// the opaque segments; a second one for the translucent ones where there are any. Behind a cut, segments go
// on as they end at it. `finest` is the growth's level in a scene's voxel space.
std::shared_ptr<const field::BrickOverlay>
fineMembership(const FineGrowth& growth, const field::BrickGrid& finest, const FineShown& shown);

} // namespace vs::segment
