// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/bricks/brick_overlay.h"
#include "field/scene.h"
#include "segment/finer/fine_front.h"
#include "segment/membership/segmentation.h"

#include <memory>

namespace vs::segment {

class FineGrowth;

// What is shown of segments that have grown at the finest level, and how.
struct FineShown {
    Looks looks = allOpaque();
    Smoothing smoothing = Smoothing::Smooth;
    bool hasTranslucent = false; // there is a channel for such ones
    glm::dvec3 sceneSpacing{1};  // mm between voxels of the scene
    // What is cut away at the finest level hides segments in this view. Both null: nothing is cut.
    field::SculptureView view = field::SculptureView::Whole;
    FineFence fence = {};
    std::shared_ptr<const field::BrickOverlay> cuts = {};
};

// How much belongs to the segments of a growth as it is now, laid over bricks of any level: what Segmentation
// is for all of a scene, found brick by brick on the host. A voxel of a coarser level is in a segment where
// at least half of its finest voxels are, or any of them where no voxel around has so many. One channel for
// the opaque segments; a second one for the translucent ones where that is wanted; then one for the label of
// the segment that has a voxel, if it is shown. Behind a cut, segments go on as they end at it, without a
// label. `finest` is the growth's level in a scene's voxel space.
std::shared_ptr<const field::BrickOverlay>
fineMembership(const FineGrowth& growth, const field::BrickGrid& finest, const FineShown& shown);

// The voxels of the finest level outside of which no other segments are shown in two of these, of one scan,
// nor in another way, but for what cuts that changed do to them.
Box3 changedBetween(const field::BrickOverlay& before, const field::BrickOverlay& now);

} // namespace vs::segment
