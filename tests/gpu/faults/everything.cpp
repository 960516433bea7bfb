// SPDX-License-Identifier: Apache-2.0
#include "gpu/faults/everything.h"

#include "gpu/studio/test_segments.h"
#include "gpu/studio/test_tools.h"

#include <fmt/format.h>

#include <iterator>

namespace vs::test {

using namespace studio;

namespace {

using Operations = std::vector<Operation>;

void append(Operations& all, const Operations& more) { all.insert(all.end(), more.begin(), more.end()); }

Operations cuts() {
    Operations all = toolsAt(200, 140);
    all.emplace_back(Undo{});
    all.emplace_back(Undo{});
    all.emplace_back(Redo{});
    all.push_back(restoring(penAt<Drill>(203, 141, 8)));
    all.emplace_back(penAt<Drill>(215, 120, 9));
    Clip clip;
    clip.planes = {{{35, 39, 30}, {0.2, 0.1, -1}}};
    all.emplace_back(clip);
    KeepConnected keep;
    keep.voxel = glm::ivec3(35, 39, 40);
    keep.canvas = testCanvas();
    all.emplace_back(keep);
    return all;
}

Operations parts() {
    ChangePart change{0};
    change.name = "lid";
    change.isVisible = false;
    return {Paste{{{80, 0, 5}}},
            penAt<Laser>(180, 130, 9),
            Paste{{{-80, 0, 5}}},
            MovePart{1, {{-90, 10, 0}}},
            change,
            UnCut{},
            Undo{},
            DiscardPart{0},
            penAt<Drill>(190, 120, 9)};
}

Operations growth() {
    SetGrowthRules live;
    live.isLive = true;
    live.range = Range{80, 130};
    SetGrowthRules narrow;
    narrow.range = Range{90, 105};
    narrow.gradient = Range{0, 30};
    Absorb absorb;
    absorb.voxels = {{35, 24, 29}};
    absorb.expansions = 3;
    absorb.canvas = testCanvas();
    return {UseSegment{"brain"},
            live,
            brainSeed(),
            Grow{6},
            Rewind{3},
            Grow{},
            ShowGeneration{5},
            absorb,
            seedAt({35, 55, 29}),
            Grow{4},
            ShowGeneration{6},
            narrow,
            Undo{},
            Undo{},
            Redo{}};
}

Trail trailAt(glm::dvec3 place) {
    Trail trail;
    trail.points = {place, place + glm::dvec3(8, 3, 0)};
    return trail;
}

Operations segments() {
    Operations all{UseSegment{"ball"}};
    PaintSegment paint;
    paint.trail = trailAt({30, 40, 30});
    all.emplace_back(paint);
    UseSegment spared{"ball"};
    spared.treatment = SegmentInfo::Treatment::Spare;
    all.emplace_back(spared);
    all.emplace_back(penAt<Drill>(200, 150, 8));
    all.emplace_back(UseSegment{"brain"});
    for (const auto kind :
         {EditSegment::Kind::KeepLargest, EditSegment::Kind::Margin, EditSegment::Kind::FillHoles,
          EditSegment::Kind::Smooth, EditSegment::Kind::Hollow}) {
        all.emplace_back(editOf(kind, 1.5));
    }
    all.emplace_back(editOf(EditSegment::Kind::Subtract, 0, "ball"));
    all.emplace_back(editOf(EditSegment::Kind::Unite, 0, "ball"));
    BrushSegment brush;
    brush.isToAdd = true;
    brush.stroke = penAt<Drill>(210, 130, 9);
    all.emplace_back(brush);
    all.emplace_back(CutSegment{false, 1});
    all.emplace_back(Undo{});
    all.emplace_back(PullOut{"brain", {{60, 0, 0}}});
    all.emplace_back(PutBack{"brain"});
    all.emplace_back(ShowSegments{"ball"});
    return all;
}

SavePicture smallPicture(const std::string& file) {
    SavePicture picture{file};
    picture.samples = 1;
    picture.size = {64, 48};
    return picture;
}

Operations files(const std::filesystem::path& labelMap) {
    SaveMovie movie{"film.png"};
    movie.samples = 1;
    movie.size = {64, 48};
    movie.framesPerSecond = 2;
    Shot growing;
    growing.kind = Shot::Kind::Growth;
    growing.seconds = 1;
    Shot again;
    again.kind = Shot::Kind::Session;
    again.seconds = 1;
    movie.shots = {growing, again};
    return {LoadLabels{labelMap},
            SaveLabels{"labels.nrrd"},
            SaveSculpture{"sculpture.nrrd"},
            smallPicture("picture.png"),
            movie,
            RemoveSegment{"ball"}};
}

Operations filling() {
    SetMaterial material;
    material.value = 120;
    return {material,
            Fill{1, penAt<Drill>(200, 130, 9)},
            Fill{1, peelAt(190, 120, 12)},
            penAt<Laser>(200, 130, 5),
            FillHole{1, test::ellipseAt(200, 130, 12, 12), {}, 3, testCanvas()},
            SegmentFill{1},
            SaveFill{"filled.nrrd"},
            SaveFillSurface{"filled.stl"},
            Unfill{penAt<Drill>(190, 120, 5)},
            Undo{},
            RemoveFill{},
            Undo{},
            smallPicture("filled.png")};
}

Operations measuring() {
    CorrectGeometry correct;
    correct.spacing = glm::dvec3(1, 1.5, 2);
    Mark mark;
    mark.kind = Mark::Kind::Area;
    mark.sketch = {Shape::Ellipse, {{180, 100}, {220, 140}}};
    mark.canvas = test::testCanvas();
    return {Measure{Measure::Kind::Distance, {{10, 20, 30}, {10.5, 20, 34}}},
            Measure{Measure::Kind::Angle, {{10, 20, 30}, {14, 20, 34}, {20, 22, 30}}},
            Measure{Measure::Kind::Cut, {}},
            RemoveMeasurement{0},
            mark,
            SaveMarks{"marks.nrrd"},
            RemoveMarks{},
            Note{"here"},
            correct};
}

} // namespace

Operations everything(const std::filesystem::path& labelMap) {
    SetView view;
    view.range = Range{50, 255};
    Operations all{view};
    append(all, cuts());
    append(all, parts());
    append(all, growth());
    append(all, segments());
    append(all, files(labelMap));
    append(all, filling());
    append(all, measuring());
    append(all, picturesOfAll());
    all.emplace_back(ReSeed{});
    all.emplace_back(Undo{});
    return all;
}

Operations picturesOfAll() {
    Operations all;
    for (std::size_t n = 0; n < std::size(render::kModes) + 1; ++n) {
        SetView view;
        view.mode = render::kModes[n % std::size(render::kModes)];
        view.sampling = n % 2 == 0 ? field::Sampling::Trilinear : field::Sampling::Tricubic;
        view.shadows = n >= 3;
        view.surfaceSmoothing = n == std::size(render::kModes) ? 1.0 : 0.0;
        all.emplace_back(view);
        all.emplace_back(smallPicture(fmt::format("p{}.png", n)));
    }
    return all;
}

} // namespace vs::test
