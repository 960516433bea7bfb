// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/clip_tool.h"
#include "tools/drill_tool.h"
#include "tools/island_tool.h"
#include "tools/keep_tool.h"
#include "tools/laser_tool.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/paint_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/sweep_tool.h"
#include "tools/tool_box.h"
#include "window/main_window.h"

#include <QActionGroup>
#include <QKeyEvent>

#include <array>

namespace vs::desktop {

namespace {
// In the order of studio::Shape.
constexpr std::array<const char*, 6> kShapeActions{"freeForm",  "ellipse",  "circle",
                                                   "rectangle", "polyline", "stencil"};
} // namespace

// One for each tool, the sign of those that cut, pasting, and the shapes that are sketched.
void MainWindow::makeToolActions() {
    auto* tools = new QActionGroup(this);
    const auto add = [&](Tool& tool, const char* name, const char* iconName, const QString& text,
                         const QString& tip, const char* key) {
        addChoice(tools, {name, iconName, text, tip, QKeySequence(key)},
                  [this, &tool] { studio_.hand().take(tool); });
    };
    add(tools_.camera(), "cameraTool", "camera", tr("Camera"), tr("Turn the volume"), "V");
    add(tools_.peel(), "peelTool", "peel", tr("Peel"), tr("Peel layers off the surface"), "P");
    add(tools_.drill(), "drillTool", "drill", tr("Drill"), tr("Drill along the view"), "D");
    add(tools_.laser(), "laserTool", "laser", tr("Laser"), tr("Burn down from the surface along its normal"),
        "B");
    add(tools_.sweep(), "sweepTool", "sweep", tr("Sweep"), tr("Sweep a shape along a way"), "W");
    add(tools_.scissors(), "scissorsTool", "scissors", tr("Scissors"),
        tr("Cut through everything inside a stroke, or outside it"), "X");
    add(tools_.keep(), "keepTool", "keep", tr("Keep"),
        tr("Keep what is connected to the place clicked, cut all else"), "K");
    add(tools_.clip(), "clipTool", "clip", tr("Clip"), tr("Clip by a box and a plane"), "C");
    add(tools_.seed(), "seedTool", "seed", tr("Seed"), tr("Mark what should be segmented"), "S");
    add(tools_.island(), "islandTool", "island", tr("Island"),
        tr("Drop the part of the segment that is clicked, or keep only it"), "H");
    add(tools_.paint(), "paintTool", "paint", tr("Paint"),
        tr("Correct the segment with a brush, on the slices"), "T");
    add(tools_.measure(), "measureTool", "measure", tr("Measure"),
        tr("Measure distances and angles, on the surface and on slices"), "M");
    add(tools_.move(), "moveTool", "move", tr("Move"), tr("Move, turn and scale pasted parts"), "G");

    QAction* restore = addAction(
        {"restore", "restore", tr("Restore"),
         tr("The tool's sign reversed: puts back instead of cutting, absorbs instead of seeding; hold the "
            "key for as long as you want it"),
         tr("R")},
        [this] { reverseSign(); });
    restore->setCheckable(true);
    restore->setAutoRepeat(false);
    addAction({"paste", "paste", tr("Paste"),
               tr("Paste what was cut since the last paste beside the object, to be moved by hand"),
               tr("Shift+V")},
              [this] { studio_.editor().paste(); })
        ->setAutoRepeat(false);

    makeShapeActions();
    addAction({"clearSketch", "clear", tr("Clear"), tr("Drop the stroke in hand, or the mask"), tr("Esc")},
              [this] { studio_.hand().tool().clear(); });
}

void MainWindow::makeShapeActions() {
    auto* shapes = new QActionGroup(this);
    const auto add = [&](studio::Shape shape, const char* iconName, const QString& text, const QString& tip,
                         const QString& key) {
        addChoice(shapes, {kShapeActions.at(std::size_t(shape)), iconName, text, tip, key},
                  [this, shape] { studio_.hand().setShape(shape); });
    };
    using studio::Shape;
    add(Shape::FreeForm, "freeform", tr("Free-form"), tr("Draw the outline by hand"), tr("F"));
    add(Shape::Ellipse, "ellipse", tr("Ellipse"), tr("Drag an ellipse from corner to corner"), tr("E"));
    add(Shape::Circle, "circle", tr("Circle"), tr("Drag a circle from its centre"), tr("O"));
    add(Shape::Rectangle, "rectangle", tr("Rectangle"), tr("Drag a rectangle from corner to corner"),
        tr("N"));
    add(Shape::Polyline, "polyline", tr("Polyline"),
        tr("Click corner after corner; Enter, a double click or the first corner ends it"), tr("Y"));
    addChoice(shapes,
              {"stencil", "stencil", tr("Picture"),
               tr("The shape that a PNG shows, bright or opaque: drag the box that it fills"), tr("I")},
              [this] { chooseStencil(); });
}

void MainWindow::chooseStencil() {
    refreshToolActions(); // until there is one, the shape is what it was
    choose("stencilDialog", tr("A picture for the mask's shape"), false, tr("Pictures (*.png)"), {},
           [this](const QString& path) {
               studio_.hand().setStencil(std::filesystem::path(path.toStdString()));
           });
}

void MainWindow::reverseSign() {
    sinceReversed_ = Timer();
    Tool& tool = studio_.hand().tool();
    tool.setReversed(!tool.isReversed());
}

// A key that was held, and not only struck, lets go of what it did.
void MainWindow::keyReleaseEvent(QKeyEvent* event) {
    constexpr double kHeldMs = 500;
    if (event->key() == Qt::Key_R && !event->isAutoRepeat() && sinceReversed_.milliseconds() > kHeldMs) {
        reverseSign();
    }
    QMainWindow::keyReleaseEvent(event);
}

void MainWindow::refreshToolActions() {
    action((studio_.hand().tool().name().toStdString() + "Tool").c_str())->setChecked(true);
    action(kShapeActions.at(std::size_t(studio_.hand().shape())))->setChecked(true);
    action("restore")->setChecked(studio_.hand().tool().isReversed());
}

} // namespace vs::desktop
