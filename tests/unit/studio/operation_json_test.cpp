// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "studio/operation_json.h"

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
                field::Sampling::Tricubic},
        SetView{},
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
        KeepConnected{{12.5, 40}, glm::ivec3(3, 4, 5), 6, someCanvas()},
        Paste{{{1, 2, 3}, {0, 90, 0}, 1.5}},
        MovePart{3, {{4, 5, 6}, {}, 1}},
        Seed{{line, ellipse}, 7, Range{30, 90.5}, 26, {{1, 2, 3}, {4, 5, 6}}, someCanvas()},
        Grow{17, field::SculptureView::Probe},
        Grow{},
        Rewind{4},
        SetGrowthRules{Range{-5, 5}},
        Undo{},
        Redo{},
        UnCut{},
        ReSeed{},
        SavePicture{"a/b.png", {320, 200}, 2},
        SavePicture{"c.png", {320, 200}, 2, render::backgroundFromName("#FFFFFF:#C0D0E0"), true},
        SaveLabels{"l.nii.gz"},
        SaveSculpture{"s.nrrd"}};
    for (const Operation& operation : operations) {
        const Json json = toJson(operation);
        const Operation back = operationFromJson(Json::parse(json.dump()), "test");
        EXPECT_EQ(back.index(), operation.index());
        EXPECT_EQ(toJson(back).dump(), json.dump());
        EXPECT_EQ(json.at("op"), name(operation));
    }
}

TEST(OperationJson, ComplaintsNameThePlace) {
    const auto complaint = [](const char* text) -> std::string {
        try {
            operationFromJson(Json::parse(text), "head.json: operation 3");
        } catch (const SessionError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(complaint(R"({"op": "rewind"})"),
              "head.json: operation 3: the member 'generations' is missing");
    EXPECT_EQ(complaint(R"({"op": "grow", "generations": -1})"),
              "head.json: operation 3: generations: -1 is out of bounds; 0 to 1073741824 is allowed");
    EXPECT_EQ(complaint(R"({"op": "drill", "mask": {"shape": "circle", "points": [[1, 2]]}})"),
              "head.json: operation 3: mask.points: this shape takes exactly two points");
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
