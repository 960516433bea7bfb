// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "studio/json/operation_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vs::studio {
namespace {

using Json = nlohmann::ordered_json;

Canvas someCanvas() {
    Canvas canvas;
    canvas.viewport = {640, 480};
    canvas.view.camera = {12.5, -30, 2, {3, -4}, render::Projection::Orthographic};
    canvas.view.mode = render::Mode::Mip;
    canvas.view.range = {-200.5, 1200};
    canvas.view.sculptureView = field::SculptureView::Probe;
    canvas.view.sampling = field::Sampling::Tricubic;
    return canvas;
}

Drill someDrill() {
    Drill drill;
    drill.mask = {Shape::FreeForm, {{1, 2}, {3, 4}, {5.5, 6.5}}};
    drill.stroke = {{{1.5, 2.5}, 0.25}, {{3, 4}, 1, {12, -30}}};
    drill.depthMax = 9;
    drill.radius = 2;
    drill.restores = true;
    drill.followsTilt = true;
    drill.canvas = someCanvas();
    return drill;
}

Mark someMark() {
    Mark mark;
    mark.sketch = {Shape::FreeForm, {{1, 2}, {3, 4}, {5.5, 6.5}}};
    mark.pressures = {0.25, 1, 0.5};
    mark.pressureSets = Mark::Pressure::Opacity;
    mark.colour = {0.5, 0.25, 1};
    mark.opacity = 0.75;
    mark.widthMm = 3.5;
    mark.softMm = 0.5;
    mark.dashMm = 6;
    mark.depthMm = 1.5;
    mark.erases = true;
    mark.canvas = someCanvas();
    return mark;
}

Mark someText() {
    Mark text;
    text.kind = Mark::Kind::Text;
    text.sketch = {Shape::FreeForm, {{1, 2}}};
    text.text = "L5";
    text.sizeMm = 8;
    return text;
}

Laser someLaser() {
    Laser laser;
    laser.mask = {Shape::Circle, {{1, 2}, {3, 4}}};
    laser.stroke = {{{1.5, 2.5}, 0.25}};
    laser.keepsDigging = true;
    return laser;
}

Sweep someSweep(SweepPath::Kind kind) {
    Sweep sweep;
    sweep.mask = {Shape::Ellipse, {{-3, -2}, {3, 2}}};
    sweep.path.kind = kind;
    if (sweep.path.isDrawn()) {
        sweep.path.stroke = {{1, 2}, {3, 4}};
        sweep.canvas = someCanvas();
    } else {
        sweep.path.points = {{1, 2, 3}, {4, 5, 6.5}};
    }
    if (kind == SweepPath::Kind::Helix) {
        sweep.path.helixRadius = 12;
        sweep.path.turns = -2.5;
    }
    sweep.frame = sculpt::FrameKind::Frenet;
    sweep.filter = {sculpt::Sampling::Uniform, sculpt::Reconstruction::MitchellNetravali, 50, 7};
    sweep.subdivision = sculpt::Subdivision::Chaikin;
    sweep.subdivisionLevels = 2;
    sweep.isRaw = true;
    sweep.method = Sweep::Method::Projection;
    return sweep;
}

UseSegment someSegment() {
    UseSegment use{"Liver"};
    use.name = "Left liver";
    use.colour = glm::dvec3(0.25, 0.5, 1);
    use.opacity = 0.5;
    use.isVisible = false;
    use.isLocked = true;
    use.treatment = SegmentInfo::Treatment::TakeOnly;
    return use;
}

std::vector<Operation> segmentOperations() {
    const Sketch line{Shape::FreeForm, {{1, 2}, {3, 4}, {5.5, 6.5}}};
    std::vector<Operation> operations{
        CorrectGeometry{glm::dvec3(0.5, 0.5, 3), "RIA"}, ShowGeneration{12}, SetGrowthRules{Range{-5, 5}},
        SetGrowthRules{Range{-5, 5}, Range{-1, 2.5}, Range{0, 40}, Range{-3, 3}, 26, true},
        // Rules that are dropped, not left as they are.
        SetGrowthRules{{}, std::optional<Range>(), std::optional<Range>(), std::optional<Range>(), 6, false},
        SetGrowthRules{}, Absorb{{line}, 7.5, 12, {{1, 2, 3}, {4, 5, 6}}, someCanvas()}, Absorb{{line}},
        someSegment(), UseSegment{"Segment 1"}, UseSegment{"Segment 1", {}, {}, {}, true, {}, false},
        UseSegment{"Liver", {}, {}, {}, {}, {}, true, true},
        UseSegment{"Segment 2", {}, {}, {}, {}, {}, true, false},
        Absorb{{{Shape::Stencil, {{1, 2}, {3, 4}, {0, 6}}}}}, LoadLabels{"labels.nii.gz"},
        LoadLabels{"/a/labels.nrrd", "0123456789abcdef"}, RemoveSegment{"Liver"}, ShowSegments{},
        ShowSegments{"Liver"}, PullOut{"Liver", {{1, -2.5, 3}, {10, 20, -30}, 1.25}},
        PullOut{"Segment 1", {}}, PutBack{"Liver"},
        EditSegment{EditSegment::Kind::DropIsland, 2.5, "Liver", glm::dvec2(12.5, 40), glm::ivec3(3, 4, 5),
                    glm::ivec3(24, 32, 40), someCanvas()},
        BrushSegment{true, Peel{line, 2, 4, false, someCanvas()}}, BrushSegment{false, Drill(someDrill())},
        BrushSegment{true, Laser(someLaser())},
        BrushSegment{false, Scissors{line, true, 12.5, 2, false, someCanvas()}},
        PaintSegment{true, {{{1, 2.5, 3}, {4, 5, 6}}, 2.5, 1}, Range{-5, 5}},
        PaintSegment{false, {{{1, 2, 3}}}}, CutSegment{true, -2.5}, CutSegment{}};
    for (int kind = 0; kind <= int(EditSegment::Kind::Intersect); ++kind) {
        operations.emplace_back(EditSegment{EditSegment::Kind(kind)});
    }
    return operations;
}

template <typename Pen>
Pen cutting(Pen pen) {
    pen.restores = false;
    return pen;
}

void expectComesBack(const Operation& operation) {
    const Json json = toJson(operation);
    const Operation back = operationFromJson(Json::parse(json.dump()), "test");
    EXPECT_EQ(back.index(), operation.index());
    EXPECT_EQ(toJson(back).dump(), json.dump());
    EXPECT_EQ(json.at("op"), name(operation));
}

TEST(OperationJson, EveryKindComesBackAsItWas) {
    const Sketch ellipse{Shape::Ellipse, {{10.25, 20}, {30, 40.125}}};
    const Sketch line{Shape::FreeForm, {{1, 2}, {3, 4}, {5.5, 6.5}}};
    const std::vector<Operation> operations{
        SetView{someCanvas().view.camera,
                render::Mode::XRay,
                Range{1, 2},
                field::SculptureView::Whole,
                {},
                {},
                field::Sampling::Tricubic,
                {},
                {},
                {},
                {},
                Range{-150, 250},
                true},
        SetView{},
        SetMaterial{2, "cement", glm::dvec3(0.5, 0.25, 1), 1200.5, false},
        SetMaterial{},
        Fill{3, Peel{ellipse, 12.75, 4, false, someCanvas()}},
        Fill{1, cutting(someDrill())},
        FillHole{2, ellipse, 12.5, 2, someCanvas()},
        FillHole{1, line},
        Unfill{Scissors{line, true, 12.5, 2, false, someCanvas()}},
        Unfill{cutting(someLaser())},
        Unfill{Clip{Clip::Box{{1, 2, 3}, {4, 5, 6}}, {}, true}},
        RemoveFill{2},
        SegmentFill{2},
        RemoveFill{},
        SaveFill{"filled.nrrd"},
        SaveFillSurface{"plate.stl", 2},
        Peel{ellipse, 12.75, 4, false, someCanvas()},
        Peel{ellipse, 2, 2, true, {}},
        someDrill(),
        someLaser(),
        someSweep(SweepPath::Kind::Surface),
        someSweep(SweepPath::Kind::Spline),
        someSweep(SweepPath::Kind::Helix),
        Scissors{line, true, 12.5, 2, true, someCanvas()},
        Scissors{ellipse},
        Clip{Clip::Box{{1, 2, 3}, {40, 50.5, 60}}, {{{1, 2, 3}, {0, 0, -1}}}, true, 4, true},
        Clip{{}, {{{1, 2, 3}, {0.5, 0, -1}}}},
        KeepConnected{glm::dvec2(12.5, 40), glm::ivec3(3, 4, 5), glm::ivec3(7, 8, 10), 6, someCanvas()},
        Paste{{{1, 2, 3}, {0, 90, 0}, 1.5}},
        MovePart{3, {{4, 5, 6}, {}, 1}},
        Seed{{line, ellipse}, 7, Range{30, 90.5}, 26, {{1, 2, 3}, {4, 5, 6}}, someCanvas()},
        Seed{{}, 5, {}, 6, {}, {}, {{{{1, 2, 3.5}}, 0, 2}, {{{1, 2, 3}, {4, 5, 6}}, 7}}},
        Grow{17, field::SculptureView::Probe},
        Grow{},
        Rewind{4},
        Undo{},
        Redo{},
        UnCut{},
        ReSeed{},
        Note{"Left for the second opinion"},
        Measure{Measure::Kind::Distance, {{1, 2.5, 3}, {4, 5, 6}}, {}},
        Measure{Measure::Kind::Angle, {{1, 2.5, 3}, {4, 5, 6}, {7, 8, 9}}, {}},
        Measure{Measure::Kind::Path, {{1, 2.5, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}}, {}},
        Measure{Measure::Kind::Area, {{1, 2.5, 3}, {4, 5, 3}, {7, 8, 3}}, {}},
        Measure{Measure::Kind::Cut, {}, 12.5},
        someMark(),
        someText(),
        RemoveMarks{},
        SaveMarks{"marks.nrrd"},
        RemoveMeasurement{3},
        RemoveMeasurement{},
        SavePicture{"a/b.png", {320, 200}, 2},
        SavePicture{"c.png", {320, 200}, 2, render::backgroundFromName("#FFFFFF:#C0D0E0"), true},
        SaveLabels{"l.nii.gz"},
        SaveSculpture{"s.nrrd"}};
    for (const Operation& operation : operations) {
        expectComesBack(operation);
    }
}

TEST(OperationJson, OperationsOnSegmentsComeBackAsTheyWere) {
    for (const Operation& operation : segmentOperations()) {
        expectComesBack(operation);
    }
    // Written and read alike could still be both wrong: a few against their text.
    EXPECT_EQ(toJson(SetGrowthRules{{}, std::optional<Range>(), Range{0, 40}}).dump(),
              R"({"op":"growth rules","difference":null,"gradient":[0.0,40.0]})");
    EXPECT_EQ(toJson(someSegment()).dump(),
              R"({"op":"segment","segment":"Liver","name":"Left liver","colour":[0.25,0.5,1.0],)"
              R"("opacity":0.5,"visible":false,"locked":true,"tools":"take only"})");
    EXPECT_EQ(toJson(CutSegment{true, 2}).dump(), R"({"op":"cut segment","keeps":true,"margin":2.0})");
}

std::string complaint(const char* text) {
    try {
        operationFromJson(Json::parse(text), "head.json: operation 3");
    } catch (const SessionError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(OperationJson, ComplaintsAboutSegmentsNameThePlace) {
    const auto expect = [](const char* text, const std::string& words) {
        EXPECT_EQ(complaint(text), "head.json: operation 3: " + words) << text;
    };
    expect(R"({"op": "show generation"})", "the member 'generation' is missing");
    expect(R"({"op": "show generation", "generation": -1})",
           "generation: -1 is out of bounds; 0 to 1073741824 is allowed");
    expect(R"({"op": "growth rules", "range": null})", "range: must be a list");
    expect(R"({"op": "growth rules", "gradient": [3, 1]})",
           "gradient: its first number must not be above its second");
    expect(R"({"op": "growth rules", "connectivity": 18})", "connectivity: must be 6 or 26");
    expect(R"({"op": "growth rules", "live": 1})", "live: must be true or false");
    expect(R"({"op": "absorb", "expansions": 3})", "needs 'strokes', 'voxels' or 'finest'");
    expect(R"({"op": "absorb", "voxels": [[1, 2]]})", "voxels[0]: must be a list of 3 numbers");
    expect(R"({"op": "geometry", "orientation": "LLS"})",
           "orientation: must be a letter of L and R, one of P and A, and one of S and I, in any order");
    expect(R"({"op": "geometry", "orientation": "LPSI"})", "orientation: must be a text of 3 characters");
    expect(R"({"op": "geometry", "spacing": [1, 0, 1]})",
           "spacing[1]: 0 is out of bounds; 1e-06 to 1000 is allowed");
    expect(R"({"op": "segment"})", "the member 'segment' is missing");
    expect(R"({"op": "segment", "segment": ""})", "segment: must be a text of 1 to 200 characters");
    expect(R"({"op": "segment", "segment": "A", "color": [0, 0, 0]})",
           "the member 'color' is not known here; known are op, segment, name, colour, opacity, visible, "
           "locked, work, first, tools");
    expect(R"({"op": "segment", "segment": "A", "tools": "shun"})",
           "tools: 'shun' is not known; choose one of take, spare, take only");
    expect(R"({"op": "segment", "segment": "A", "colour": [0, 255, 0]})",
           "colour[1]: 255 is out of bounds; 0 to 1 is allowed");
    expect(R"({"op": "segment", "segment": "A", "opacity": 0})",
           "opacity: 0 is out of bounds; 0.01 to 1 is allowed");
    expect(R"({"op": "remove segment", "segment": 3})", "segment: must be a text");
    expect(
        R"({"op": "edit segment", "edit": "grow"})",
        "edit: 'grow' is not known; choose one of keep island, drop island, keep largest, drop small, fill "
        "holes, margin, open, close, smooth, hollow, unite, subtract, intersect");
    expect(R"({"op": "edit segment", "edit": "margin", "amount": 1e5})",
           "amount: 100000 is out of bounds; -10000 to 10000 is allowed");
    expect(R"({"op": "brush segment", "adds": true})", "the member 'stroke' is missing");
    expect(R"({"op": "brush segment", "adds": true, "stroke": {"op": "undo"}})",
           "stroke.op: 'undo' is not known; choose one of peel, drill, laser, scissors");
    expect(R"({"op": "brush segment", "adds": true, "stroke": {"op": "peel", "layers": 1}})",
           "stroke: the member 'mask' is missing");
    expect(R"({"op": "cut segment", "keep": true})",
           "the member 'keep' is not known here; known are op, keeps, margin");
}

TEST(OperationJson, ComplaintsNameThePlace) {
    EXPECT_EQ(complaint(R"({"op": "rewind"})"),
              "head.json: operation 3: the member 'generations' is missing");
    EXPECT_EQ(complaint(R"({"op": "grow", "generations": -1})"),
              "head.json: operation 3: generations: -1 is out of bounds; 0 to 1073741824 is allowed");
    EXPECT_EQ(complaint(R"({"op": "drill", "mask": {"shape": "circle", "points": [[1, 2]]}})"),
              "head.json: operation 3: mask.points: this shape takes exactly two points");
    const auto path = [](const char* kind, const char* points) {
        return fmt::format(R"({{"op": "sweep", "mask": {{"shape": "circle", "points": [[0, 0], [1, 0]]}},
                                "path": {{"kind": "{}", "points": {}, "radius": 1, "turns": 1}}}})",
                           kind, points);
    };
    for (const char* kind : {"helix", "standing"}) {
        for (const char* points : {"[[1, 2, 3]]", "[[1, 2, 3], [3, 4, 5], [5, 6, 7]]"}) {
            EXPECT_EQ(complaint(path(kind, points).c_str()),
                      "head.json: operation 3: path.points: exactly two places are wanted");
        }
    }
    EXPECT_EQ(complaint(path("standing", "[[1, 2, 3], [1, 2, 3]]").c_str()),
              "head.json: operation 3: path.points: the mask must face another place than it stands on");
    EXPECT_EQ(complaint(path("spline", "[[1, 2, 3]]").c_str()),
              "head.json: operation 3: path.points: must have at least 2 entries");
    EXPECT_EQ(complaint(path("spline", "[[1, 2, 3], [3, 4, 5], [5, 6, 7]]").c_str()), "accepted");
    EXPECT_EQ(complaint(R"({"op": "view", "range": [9, 1]})"),
              "head.json: operation 3: range: its first number must not be above its second");
    EXPECT_EQ(complaint(R"({"op": "picture", "file": "/etc/x.png"})"),
              "head.json: operation 3: file: a file name inside the output folder is wanted");
    for (const char* file : {".", "a/", "a/."}) {
        EXPECT_EQ(complaint(fmt::format(R"({{"op": "labels", "file": "{}"}})", file).c_str()),
                  "head.json: operation 3: file: a file name is wanted, not a folder's");
    }
    EXPECT_NE(complaint(R"({"op": "picture", "file": "./report.json"})").find("report.json is what"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"op": "picture", "file": ""})").find("file: must be the name"),
              std::string::npos);
    EXPECT_EQ(
        complaint(
            R"({"op": "peel", "layers": 1, "mask": {"shape": "circle", "points": [[1, 2], [1e7, 2]]}})"),
        "head.json: operation 3: mask.points[1][0]: 10000000 is out of bounds; -1000000 to 1000000 is "
        "allowed");
    EXPECT_EQ(
        complaint(R"({"op": "drill", "stroke": [[1, -2e6, 1]],
                            "mask": {"shape": "circle", "points": [[1, 2], [3, 2]]}})"),
        "head.json: operation 3: stroke[0][1]: -2000000 is out of bounds; -1000000 to 1000000 is allowed");
    EXPECT_EQ(complaint(R"([1])"), "head.json: operation 3: must be an object");
}

} // namespace
} // namespace vs::studio
