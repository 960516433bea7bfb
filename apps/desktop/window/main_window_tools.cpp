// SPDX-License-Identifier: Apache-2.0
#include "model/hand/tool.h"
#include "model/studio/studio_controller.h"
#include "panels/tool_rows.h"
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
    for (const ToolRow& row : toolRows(tools_)) {
        const std::string icon = row.tool.name().toStdString();
        addChoice(tools, {(icon + "Tool").c_str(), icon.c_str(), row.text, row.tip, QKeySequence(row.key)},
                  [this, &tool = row.tool] { studio_.hand().take(tool); });
    }

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
