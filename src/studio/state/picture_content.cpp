// SPDX-License-Identifier: Apache-2.0
#include "studio/state/picture_content.h"

namespace vs::studio {

namespace {

// How far from a ray lies what it looks at, in voxels: tricubic gradients reach two and a half, the colour of
// a segment is looked for one step further inwards and in the cell around that.
constexpr int kReach = 4;

std::optional<Box3> changedBetween(const PictureContent::Segments& before,
                                   const PictureContent::Segments& now,
                                   const segment::Segmentation* segmentation) {
    if (!before.areDrawn && !now.areDrawn) {
        return Box3{};
    }
    // Of segments that are no more nobody knows where they were.
    if (segmentation == nullptr || (before.areDrawn && before.making != now.making)) {
        return std::nullopt;
    }
    if (!before.areDrawn || !now.areDrawn) {
        return segmentation->changedSince(0);
    }
    const bool isSame = before.looks == now.looks && before.colours.entries == now.colours.entries &&
                        before.haveLabels == now.haveLabels;
    return isSame ? std::optional(segmentation->changedSince(before.version)) : std::nullopt;
}

} // namespace

View viewOfPicture(View view) {
    view.mode = view.mode == render::Mode::Segment ? render::Mode::Surface : view.mode;
    view.sliceWindow = {};
    view.tintsSlices = false;
    return view;
}

std::optional<Box3> changedBetween(const PictureContent& before, const PictureContent& now,
                                   const sculpt::Sculpture& sculpture,
                                   const segment::Segmentation* segmentation) {
    const bool isSame =
        before.isLocal && now.isLocal && before.view == now.view && before.fieldSerial == now.fieldSerial &&
        before.functionVersion == now.functionVersion && before.showsUncut == now.showsUncut &&
        before.isCutAlongSegments == now.isCutAlongSegments;
    const auto segments = isSame ? changedBetween(before.segments, now.segments, segmentation) : std::nullopt;
    if (!segments) {
        return std::nullopt;
    }
    const bool marksMoved =
        !before.marks->isEmpty() && !now.marks->isEmpty() && !(before.marks->grid() == now.marks->grid());
    if (marksMoved) {
        return std::nullopt;
    }
    const bool materialsChanged = !(*before.filled.materials == *now.filled.materials) &&
                                  !(before.filled.fill->isEmpty() && now.filled.fill->isEmpty());
    if (materialsChanged) {
        return std::nullopt;
    }
    const Box3 filled = field::changedBetween(*before.filled.fill, *now.filled.fill);
    const Box3 marked = field::changedBetween(*before.marks, *now.marks);
    const Box3 box =
        unite(unite(unite(*segments, filled), marked), sculpture.changedSince(before.sculptureVersion));
    return box.isEmpty() ? box : intersect(grow(box, kReach), {glm::ivec3(0), sculpture.dims()});
}

} // namespace vs::studio
