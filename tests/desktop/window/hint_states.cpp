// SPDX-License-Identifier: Apache-2.0
#include "hint_states.h"

#include "hint_walk.h"
#include "model/segments/growth_controller.h"
#include "tools/drill_tool.h"
#include "tools/laser_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/sweep_tool.h"

namespace vs::desktop {

namespace {

using studio::Shape;

class SketchWalk : public HintWalk {
public:
    using HintWalk::HintWalk;

    void all() {
        w_.window().resize(1100, 760);
        w_.open();
        pens();
        peel();
        sweep();
        scissors();
        seeds();
        w_.studio().hand().tool().setReversed(false);
        w_.studio().growth().setAutoStart(true);
        w_.studio().hand().setShape(Shape::FreeForm);
    }

private:
    void pens() {
        for (PenTool* tool :
             std::initializer_list<PenTool*>{&w_.tools().get<DrillTool>(), &w_.tools().get<LaserTool>()}) {
            const std::string name = tool->name().toStdString();
            choose(*tool);
            if (name == "drill") {
                sketch(name, Shape::FreeForm, "free-form");
                sketch(name, Shape::Ellipse, "ellipse");
                sketch(name, Shape::Circle, "circle");
                sketch(name, Shape::Rectangle, "rectangle");
                takeStencil();
                sketch(name, Shape::Stencil, "picture");
            }
            polyline(name);
            closePolyline();
            mouse_.move(kMiddle);
            look(name + ": mask");
            mouse_.press(kMiddle);
            look(name + ": cutting");
            mouse_.release(kMiddle);
            w_.settle();
            tool->setReversed(true);
            look(name + ", reversed: mask");
            mouse_.press(kMiddle);
            look(name + ", reversed: cutting");
            mouse_.release(kMiddle);
            w_.settle();
            choose(*tool);
        }
    }
    void peel() {
        choose(w_.tools().get<PeelTool>());
        polyline("peel");
        closePolyline();
        for (const bool isReversed : {false, true}) {
            const std::string name = isReversed ? "peel, reversed" : "peel";
            w_.studio().hand().tool().setReversed(isReversed);
            mouse_.move(kMiddle);
            look(name + ": mask");
            mouse_.press(kMiddle);
            mouse_.move(kMiddle + QPointF(0, 30.0 / w_.view().height()));
            look(name + ": peeling");
            mouse_.release(kMiddle + QPointF(0, 30.0 / w_.view().height()));
            w_.settle();
        }
    }
    void sweep() {
        SweepTool& tool = w_.tools().get<SweepTool>();
        choose(tool);
        const auto before = tool.settings();
        for (const bool isAtOnce : {false, true}) {
            auto settings = before;
            settings.cutsAtPenUp = isAtOnce;
            tool.set(settings);
            const std::string name = isAtOnce ? "sweep at once" : "sweep";
            polyline(name);
            closePolyline();
            look(name + ": mask");
            mouse_.press(kA);
            mouse_.move(kMiddle);
            look(name + ": way held");
            mouse_.release(kB);
            w_.settle();
            look(name + ": after the way");
            tool.clear();
            tool.clear();
        }
        auto settings = before;
        settings.way = SweepTool::Way::Line;
        tool.set(settings);
        w_.studio().hand().setShape(Shape::Polyline);
        for (const QPointF place : {kA, kB, kC, kA}) {
            mouse_.click(place);
        }
        w_.settle();
        look("sweep, line: mask");
        tool.setReversed(true);
        w_.settle();
        look("sweep, line, reversed: mask");
        tool.set(before);
    }
    void scissors() {
        ScissorsTool& tool = w_.tools().get<ScissorsTool>();
        for (const bool isOutside : {false, true}) {
            for (const bool isReversed : {false, true}) {
                choose(tool);
                tool.setCutsOutside(isOutside);
                tool.setReversed(isReversed);
                const std::string name = std::string("scissors") + (isOutside ? ", outside" : "") +
                                         (isReversed ? ", reversed" : "");
                sketch(name, Shape::FreeForm, "free-form");
                polyline(name);
                dropPolyline();
            }
        }
        tool.setCutsOutside(false);
    }
    void seeds() {
        auto& growth = w_.studio().growth();
        for (const bool starts : {true, false}) {
            for (const bool isReversed : {false, true}) {
                growth.setAutoStart(starts);
                choose(w_.tools().get<SeedTool>());
                w_.studio().hand().tool().setReversed(isReversed);
                const std::string name =
                    std::string(isReversed ? "absorb" : "seed") + (starts ? "" : ", no start");
                sketch(name, Shape::FreeForm, "free-form");
                if (starts && !isReversed) {
                    sketch(name, Shape::Rectangle, "rectangle");
                    takeStencil();
                    sketch(name, Shape::Stencil, "picture");
                }
                polyline(name);
                dropPolyline();
            }
        }
    }
};

} // namespace

void forEachSketchHint(StudioWindow& window, const HintWalk::Look& look) { SketchWalk(window, look).all(); }

} // namespace vs::desktop
