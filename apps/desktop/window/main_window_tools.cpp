// SPDX-License-Identifier: Apache-2.0
#include "model/hand/tool.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/tool_rows.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include <QActionGroup>
#include <QKeyEvent>

namespace vs::desktop {

// One for each tool, the sign of those that cut, pasting, and the shapes that are sketched.
void MainWindow::makeToolActions() {
    auto* tools = new QActionGroup(this);
    for (const ToolRow& row : toolRows(tools_)) {
        const std::string picture = row.pictureName();
        actions_->addChoice(tools, {row.actionName(),
                                    picture.c_str(),
                                    row.text,
                                    row.tip,
                                    QKeySequence(row.key),
                                    [this, &tool = row.tool] { studio_.hand().take(tool); },
                                    {},
                                    [this, &tool = row.tool] { return &studio_.hand().tool() == &tool; }});
    }
    actions_
        ->add({"restore", "restore", tr("Restore"),
               tr("The tool's sign reversed: puts back instead of cutting, absorbs instead of seeding; hold "
                  "the key for as long as you want it"),
               tr("R"), [this] { reverseSign(); },
               [this] { return isOpen() && studio_.hand().tool().hasSign(); },
               [this] { return studio_.hand().tool().isReversed(); }})
        ->setAutoRepeat(false);
    actions_
        ->add({"paste", "paste", tr("Paste"),
               tr("Paste what tools cut since the last paste beside the object, to be moved by hand"),
               tr("Shift+V"), [this] { studio_.editor().paste(); }})
        ->setAutoRepeat(false);
    actions_
        ->add({"pasteAll", "paste", tr("Paste All"),
               tr("Paste what was cut since the last paste, also what Keep and Clip took away"),
               tr("Ctrl+Alt+V"), [this] { studio_.editor().paste(true); }})
        ->setAutoRepeat(false);
    actions_
        ->add(
            {"pullOut", "paste", tr("Pull Out"),
             tr("Draw the segment at work once more beside the object, to be moved by hand; it stays in its "
                "place too. Again: no more"),
             tr("Ctrl+Shift+V"),
             [this] { studio_.segments().pullOut(std::string(studio_.segments().list().working().name)); },
             [this] { return isOpen(); },
             [this] { return isOpen() && studio_.segments().list().working().pulledOut.has_value(); }})
        ->setAutoRepeat(false);

    makeShapeActions();
    actions_->add({"clearSketch", "clear", tr("Clear"), tr("Drop the stroke in hand, or the mask"), tr("Esc"),
                   [this] { studio_.hand().tool().clear(); }});
}

void MainWindow::makeShapeActions() {
    auto* shapes = new QActionGroup(this);
    const auto add = [&](studio::Shape shape, const char* name, const char* icon, const QString& text,
                         const QString& tip, const QString& key, const std::function<void()>& run = {}) {
        const auto take = [this, shape] { studio_.hand().setShape(shape); };
        actions_->addChoice(shapes, {name, icon, text, tip, key, run ? run : take, {}, [this, shape] {
                                         return studio_.hand().shape() == shape;
                                     }});
    };
    using studio::Shape;
    add(Shape::FreeForm, "freeForm", "freeform", tr("Free-form"), tr("Draw the outline by hand"), tr("F"));
    add(Shape::Ellipse, "ellipse", "ellipse", tr("Ellipse"), tr("Drag an ellipse from corner to corner"),
        tr("E"));
    add(Shape::Circle, "circle", "circle", tr("Circle"), tr("Drag a circle from its centre"), tr("O"));
    add(Shape::Rectangle, "rectangle", "rectangle", tr("Rectangle"),
        tr("Drag a rectangle from corner to corner"), tr("N"));
    add(Shape::Polyline, "polyline", "polyline", tr("Polyline"),
        tr("Click corner after corner; Enter, a double click or the first corner ends it"), tr("Y"));
    add(Shape::Stencil, "stencil", "stencil", tr("Picture"),
        tr("The shape that a PNG shows, bright or opaque: drag the box that it fills"), tr("I"),
        [this] { chooseStencil(); });
}

void MainWindow::chooseStencil() {
    actions_->refresh(); // until there is one, the shape is what it was
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

} // namespace vs::desktop
