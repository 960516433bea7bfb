// SPDX-License-Identifier: Apache-2.0
#include "model/document/geometry_draft.h"

#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kRounding = 1e-9; // relative: what is nearer to the file's spacing is the file's

// The patient directions that a slice's picture has at its edges.
struct Edges {
    char right;
    char left;
    char bottom;
    char top;
};

Edges edgesOf(render::SliceKind slice) {
    switch (slice) {
    case render::SliceKind::Axial:
        return {'L', 'R', 'P', 'A'};
    case render::SliceKind::Coronal:
        return {'L', 'R', 'I', 'S'};
    case render::SliceKind::Sagittal:
        break;
    }
    return {'P', 'A', 'I', 'S'};
}

} // namespace

GeometryDraft::GeometryDraft(const volume::GridGeometry& file, const volume::GridGeometry& present)
    : file_(file), orientation_(present.orientationCode()) {
    setSpacing(present.spacing());
}

void GeometryDraft::turn(render::SliceKind slice, Turn turn) {
    const Edges edges = edgesOf(slice);
    // Which of a voxel axis' two ends lies at the right and at the bottom is said by its letter.
    const std::size_t across = orientation_.find_first_of({edges.right, edges.left});
    const std::size_t down = orientation_.find_first_of({edges.bottom, edges.top});
    const bool runsRight = orientation_[across] == edges.right;
    const bool runsDown = orientation_[down] == edges.bottom;
    switch (turn) {
    case Turn::FlipAcross:
        orientation_[across] = runsRight ? edges.left : edges.right;
        break;
    case Turn::FlipDown:
        orientation_[down] = runsDown ? edges.top : edges.bottom;
        break;
    case Turn::Clockwise: // the right goes to the bottom, the bottom to the left
        orientation_[across] = runsRight ? edges.bottom : edges.top;
        orientation_[down] = runsDown ? edges.left : edges.right;
        break;
    case Turn::Exchange:
        orientation_[across] = runsRight ? edges.bottom : edges.top;
        orientation_[down] = runsDown ? edges.right : edges.left;
        break;
    }
}

void GeometryDraft::setSpacing(glm::dvec3 mm) {
    const glm::dvec3 file = file_.spacing();
    for (int axis = 0; axis < 3; ++axis) {
        spacing_[axis] = std::abs(mm[axis] - file[axis]) <= kRounding * file[axis] ? file[axis] : mm[axis];
    }
}

void GeometryDraft::reset() {
    orientation_ = file_.orientationCode();
    spacing_ = file_.spacing();
}

studio::CorrectGeometry GeometryDraft::correction() const {
    studio::CorrectGeometry correction;
    if (spacing_ != file_.spacing()) {
        correction.spacing = spacing_;
    }
    if (orientation_ != file_.orientationCode()) {
        correction.orientation = orientation_;
    }
    return correction;
}

volume::GridGeometry GeometryDraft::grid() const { return correction().corrected(file_); }

} // namespace vs::desktop
