// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "render/colours/segment_colours.h"
#include "sculpt/sculpture/sculpture.h"
#include "segment/membership/segmentation.h"
#include "studio/operations/view.h"
#include "studio/state/filled.h"

#include <cstdint>
#include <optional>

namespace vs::studio {

// What a picture shows, by the numbers of the versions that it was made of: enough to tell where another one
// may differ, so that only that need be cast anew (doc/decisions/0034).
struct PictureContent {
    // The segments.
    struct Segments {
        bool areDrawn = false;
        int making = 0;            // counts the volumes of memberships that were made
        std::uint64_t version = 0; // segment::Segmentation::version(); this and the rest where they are drawn
        segment::Looks looks = segment::allOpaque();
        render::SegmentColours colours;
        bool haveLabels = false;        // those of voxels are asked
        std::uint64_t finerVersion = 0; // of those that finer levels show; 0: none
    };

    View view; // what pictures go by: see viewOfPicture()
    std::uint64_t fieldSerial = 0;
    int functionVersion = 0; // of the tables of the transfer function
    std::uint64_t sculptureVersion = 0;
    bool isRough = false;    // with a stroke in hand that finer levels do not have yet
    bool showsUncut = false; // in a view of what was cut, because nothing was
    bool isCutAlongSegments = false;
    Segments segments;
    field::SharedMarks marks = std::make_shared<const field::Marks>();
    Filled filled;
    // All is drawn where it lies, and throws no shadow: a change shows along the rays through it and nowhere
    // else.
    bool isLocal = false;
};

// A view without what its picture does not depend on. Surface and segment mode are one: they differ where
// segments are.
View viewOfPicture(View view);

// The voxels along whose rays two pictures of one document may differ: the contents `before` and `now`, of
// which the sculpture and the segments (null: there are none) are the present ones. Nothing: everywhere.
std::optional<Box3> changedBetween(const PictureContent& before, const PictureContent& now,
                                   const sculpt::Sculpture& sculpture,
                                   const segment::Segmentation* segmentation);

} // namespace vs::studio
