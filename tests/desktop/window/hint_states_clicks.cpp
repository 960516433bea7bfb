// SPDX-License-Identifier: Apache-2.0
#include "hint_states.h"

#include "hint_walk.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "tools/camera_tool.h"
#include "tools/clip_tool.h"
#include "tools/drill_tool.h"
#include "tools/island_tool.h"
#include "tools/mark_tool.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"

namespace vs::desktop {

namespace {

using studio::Shape;

class ClickWalk : public HintWalk {
public:
    using HintWalk::HintWalk;

    void all() {
        w_.window().resize(1100, 760);
        w_.open();
        w_.studio().growth().setAutoStart(false); // the seeds stay few
        clicks();
        onASegment();
        pasted();
        w_.studio().growth().setAutoStart(true);
        w_.studio().hand().setShape(Shape::FreeForm);
    }

private:
    // Tools that are clicked with.
    void clicks() {
        auto& studio = w_.studio();
        auto& tools = w_.tools();
        choose(tools.get<CameraTool>());
        look("camera");
        w_.trigger("keepTool");
        look("keep");
        mouse_.press(kMiddle);
        look("keep: held");
        studio.hand().tool().clear();
        mouse_.release(kMiddle);
        w_.trigger("clipTool");
        look("clip");
        studio.hand().tool().setReversed(true);
        look("clip, reversed");
        tools.get<ClipTool>().setCutsInside(true);
        look("clip, inside, reversed");
        studio.hand().tool().setReversed(false);
        look("clip, inside");
        w_.open(); // without it
        choose(tools.get<MeasureTool>());
        look("measure");
        tools.get<MeasureTool>().setKind(MeasureTool::Kind::Angle);
        look("measure, angle");
        mouse_.press(kA);
        look("measure, angle: held on the first place");
        mouse_.release(kA);
        look("measure, angle: one place");
        mouse_.press(kB);
        look("measure, angle: held on the second place");
        mouse_.release(kB);
        look("measure, angle: two places");
        tools.get<MeasureTool>().clear();
        for (const auto kind : {MeasureTool::Kind::Path, MeasureTool::Kind::Area}) {
            const bool isPath = kind == MeasureTool::Kind::Path;
            tools.get<MeasureTool>().setKind(kind);
            look(isPath ? "measure, path" : "measure, area");
            mouse_.press(kA);
            look(isPath ? "measure, path: held" : "measure, area: held on the surface");
            tools.get<MeasureTool>().clear();
            mouse_.release(kA);
        }
        tools.get<MeasureTool>().setKind(MeasureTool::Kind::Distance);
        mouse_.press({0.03, 0.97});
        look("measure: held beside the object");
        mouse_.release({0.03, 0.97});
        marks();
        choose(tools.get<IslandTool>());
        look("island: empty segment");
        w_.trigger("paintTool");
        look("paint: no slices");
        w_.trigger("slices");
        look("paint");
        w_.trigger("only3D");
        w_.settle();
    }

    void marks() {
        auto& mark = w_.tools().get<MarkTool>();
        choose(mark);
        for (const bool erases : {true, false}) {
            mark.setReversed(erases);
            const std::string name = erases ? "mark, erasing" : "mark";
            mark.setKind(MarkTool::Kind::Text);
            look(name + ", letters");
            for (const auto kind : {MarkTool::Kind::Area, MarkTool::Kind::Arrow, MarkTool::Kind::Line}) {
                mark.setKind(kind);
                sketch(name + ", kind " + std::to_string(int(kind)), Shape::Circle, "circle");
                polyline(name + ", kind " + std::to_string(int(kind)));
                mark.clear();
            }
            w_.studio().hand().setShape(Shape::FreeForm);
            look(name);
            mouse_.press(kMiddle);
            look(name + ": held");
            mark.clear();
            mouse_.release(kMiddle);
        }
    }

    // Segments: with voxels, locked, and tools that act on one.
    void onASegment() {
        auto& studio = w_.studio();
        auto& tools = w_.tools();
        choose(tools.get<SeedTool>());
        studio.hand().setShape(Shape::FreeForm);
        mouse_.drag({kA, kMiddle, kB});
        w_.settle();
        choose(tools.get<IslandTool>());
        look("island");
        mouse_.press(kMiddle);
        look("island: held");
        studio.hand().tool().setReversed(true);
        look("island, reversed: held");
        studio.hand().tool().clear();
        mouse_.release(kMiddle);
        look("island, reversed");
        studio.hand().tool().setReversed(false);
        studio.hand().setTarget(Hand::Target::Segment);
        choose(tools.get<ScissorsTool>());
        sketch("scissors on a segment", Shape::FreeForm, "free-form");
        studio.hand().tool().setReversed(true);
        sketch("scissors on a segment, reversed", Shape::FreeForm, "free-form");
        choose(tools.get<PeelTool>());
        polyline("peel on a segment");
        closePolyline();
        look("peel on a segment: mask");
        choose(tools.get<DrillTool>());
        look("drill on a segment: nothing drawn");
        studio.segments().setLocked("Segment 1", true);
        for (const char* tool : {"drillTool", "seedTool", "islandTool", "paintTool"}) {
            w_.trigger(tool);
            look(std::string(tool) + ": locked segment");
        }
        studio.hand().setTarget(Hand::Target::Material);
        w_.trigger("drillTool");
        look("drill on material: nothing drawn");
        studio.hand().tool().setReversed(true);
        look("drill on material, reversed: nothing drawn");
        studio.hand().tool().setReversed(false);
        studio.hand().setPicksValue(true);
        look("drill on material: picking");
        studio.hand().setPicksValue(false);
        choose(tools.get<ScissorsTool>());
        sketch("scissors on material", Shape::FreeForm, "free-form");
        studio.hand().tool().setReversed(true);
        sketch("scissors on material, reversed", Shape::FreeForm, "free-form");
        studio.hand().tool().setReversed(false);
        studio.hand().setTarget(Hand::Target::Scan);
        w_.trigger("drillTool");
        look("drill on the scan: locked segment");
    }

    void pasted() {
        auto& studio = w_.studio();
        auto& tools = w_.tools();
        choose(tools.get<MoveTool>());
        look("move: nothing pasted");
        choose(tools.get<ScissorsTool>());
        studio.hand().setShape(Shape::Ellipse);
        mouse_.drag({{0.45, 0.3}, {0.5, 0.35}, {0.55, 0.4}});
        w_.settle();
        studio.editor().paste();
        w_.settle();
        look("move");
        const QPointF handle = tools.get<MoveTool>().handles().front();
        const QPointF place(handle.x() / w_.view().width(), handle.y() / w_.view().height());
        mouse_.press(place);
        mouse_.move(place + QPointF(0.02, 0));
        look("move: held");
        studio.hand().tool().clear();
        mouse_.release(place);
        mouse_.press({0.02, 0.98});
        look("move: held beside it");
        mouse_.release({0.02, 0.98});
    }
};

} // namespace

void forEachClickHint(StudioWindow& window, const HintWalk::Look& look) { ClickWalk(window, look).all(); }

} // namespace vs::desktop
