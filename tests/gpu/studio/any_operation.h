// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/studio/any_edit.h"

#include <string>
#include <utility>

namespace vs::test {

// Operations of every kind that there is on the head of tests, those that look and those that write small
// files too, drawn at random. Edits that stroke and grow come most often.
class AnyOperation : public AnyEdit {
public:
    using AnyEdit::AnyEdit;

    [[nodiscard]] Operation anything() const {
        const int kind = below(40);
        return kind == 0   ? output()
               : kind < 4  ? look()
               : kind < 7  ? measurement()
               : kind < 14 ? more()
                           : edit();
    }

private:
    // Looks from elsewhere.
    [[nodiscard]] Operation look() const;
    [[nodiscard]] Operation measurement() const;
    // Edits that AnyEdit leaves out.
    [[nodiscard]] Operation more() const;
    // Writes a file of a few kilobytes.
    [[nodiscard]] Operation output() const;
    [[nodiscard]] studio::Trail trail() const;
    [[nodiscard]] glm::dvec3 place() const;
};

// In or about the head, in voxels.
inline glm::dvec3 AnyOperation::place() const {
    const double x = 5.5 * below(14);
    const double y = 5.5 * below(15);
    return {x, y, 5.5 * below(11)};
}

inline studio::Trail AnyOperation::trail() const {
    studio::Trail trail;
    trail.points = {place(), place()};
    trail.radiusMm = 1 + below(6);
    if (below(2) == 0) {
        trail.axis = below(3);
        trail.points[1][*trail.axis] = trail.points[0][*trail.axis]; // it lies in a slice
    }
    return trail;
}

inline Operation AnyOperation::look() const {
    studio::SetView look;
    switch (below(4)) {
    case 0:
        look.camera = render::Camera{15.0 * below(24), 10.0 * below(9) - 40, 1 + 0.25 * below(5)};
        break;
    case 1:
        look.mode = render::kModes[below(6)];
        look.shadows = below(2) == 0;
        look.tintsSegments = below(2) == 0;
        break;
    case 2:
        look.range = below(2) == 0 ? Range{50, 255} : Range{30, 150};
        look.sculptureView = field::SculptureView(below(3));
        break;
    default:
        look.spread = 0.5 * below(3);
        look.sliceWindow = Range{0, 100.0 + below(100)};
        look.surfaceSmoothing = 0.5 * below(3);
        look.sampling = field::Sampling(below(2));
    }
    return look;
}

inline Operation AnyOperation::measurement() const {
    using Kind = studio::Measure::Kind;
    switch (below(6)) {
    case 0:
        return studio::Measure{Kind::Angle, {place(), place(), place()}};
    case 1:
        return studio::Measure{Kind::Path, {place(), place(), place(), place()}};
    case 2: {
        const double z = below(60);
        return studio::Measure{Kind::Area, {{10, 10, z}, {40.0 + below(20), 12, z}, {30, 50, z}}};
    }
    case 3:
        return studio::Measure{below(2) == 0 ? Kind::Cut : Kind::Vessel, {}};
    case 4:
        return studio::RemoveMeasurement{below(4)};
    default:
        return below(8) == 0 ? Operation(studio::RemoveMeasurement{})
                             : Operation(studio::Measure{Kind::Distance, {place(), place()}});
    }
}

inline Operation AnyOperation::more() const {
    switch (below(10)) {
    case 9: {
        studio::KeepConnected keep;
        keep.voxel = glm::ivec3(35, 11, 29); // of the skull, which is visible
        keep.connectivity = below(2) == 0 ? 6 : 26;
        return keep;
    }
    case 0:
        return studio::PutBack{};
    case 1:
        return below(3) == 0 ? Operation(studio::ReSeed{}) : Operation(studio::ShowSegments{});
    case 2:
        return studio::ShowSegments{"Segment 1"};
    case 3:
    case 4: {
        const auto brushes = strokes();
        return studio::BrushSegment{below(2) == 0, brushes[std::size_t(below(int(brushes.size())))]};
    }
    case 5: {
        studio::Clip box;
        box.box = studio::Clip::Box{{double(below(20)), 10, 5}, {50, 40.0 + below(30), 50}};
        box.cutsInside = below(2) == 0;
        return box;
    }
    case 6: {
        studio::CorrectGeometry correct;
        correct.orientation = below(2) == 0 ? "LPS" : "RAS";
        return correct;
    }
    default: {
        studio::PaintSegment paint;
        paint.isToAdd = below(4) != 0;
        paint.trail = trail();
        paint.range = below(2) == 0 ? std::optional(Range{80, 120}) : std::nullopt;
        return paint;
    }
    }
}

inline Operation AnyOperation::output() const {
    switch (below(7)) {
    case 0: {
        studio::SavePicture picture{"picture.png", {48, 36}, 1};
        picture.annotations = below(2) == 0;
        picture.strokes = studio::ShownStrokes(below(3));
        return picture;
    }
    case 1:
        return studio::SaveLabels{below(2) == 0 ? "labels.nrrd" : "labels.nii.gz"};
    case 2:
        return studio::SaveFill{"filled.nrrd"};
    case 3:
        return studio::SaveFillSurface{"filled.stl"};
    case 4:
        return studio::SaveMarks{"marks.nrrd"};
    case 5:
        return studio::SaveSculpture{"sculpture.nrrd"};
    default: {
        studio::SaveMovie movie{"movie", {32, 24}, 10, 1};
        studio::Shot shot;
        shot.kind = below(2) == 0 ? studio::Shot::Kind::Still : studio::Shot::Kind::Growth;
        shot.seconds = 0.2;
        shot.orbit = studio::Shot::Orbit(below(6));
        shot.amount = shot.orbit == studio::Shot::Orbit::Approach ? 2 : 90;
        movie.shots = {shot};
        return movie;
    }
    }
}

} // namespace vs::test
