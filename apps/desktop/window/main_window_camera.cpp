// SPDX-License-Identifier: Apache-2.0
// From where the volume is looked at: the standard views, fitting, and how it turns.
#include "model/document/camera_motion.h"
#include "model/hand/tool.h"
#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/tool_box.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

namespace vs::desktop {

void MainWindow::makeCameraActions() {
    CameraMotion& camera = studio_.camera();
    // The picture holds still while something is drawn on it.
    const auto unlessDrawing = [this](const std::function<void()>& look) {
        return [this, look] {
            if (!studio_.hand().tool().isSketching()) {
                look();
            }
        };
    };
    actions_->add({"resetView", "reset", tr("Reset"), tr("Look at the face again, all of it"), tr("Home"),
                   unlessDrawing([&camera] { camera.reset(); })});
    actions_->add({"fitView", nullptr, tr("Fit"),
                   tr("Show all that can be seen as large as there is room for"), tr("Shift+F"),
                   unlessDrawing([&camera] { camera.fit(); })});
    for (const StandardView& view : CameraMotion::standardViews()) {
        actions_->add({"from." + view.name, nullptr, view.text, view.tip, QKeySequence(view.key),
                       unlessDrawing([&camera, view] { camera.lookFrom(view.direction); })});
    }
    makeDragActions();
    actions_->add({"orthographic",
                   nullptr,
                   tr("Orthographic"),
                   tr("Without perspective: what is farther off is as large"),
                   tr("Shift+O"),
                   unlessDrawing([&camera] { camera.setOrthographic(!camera.isOrthographic()); }),
                   {},
                   [&camera] { return camera.isOrthographic(); }});
    actions_->add({"turntable",
                   nullptr,
                   tr("Turntable"),
                   tr("The head stays up while the volume is turned, instead of rolling under the hand"),
                   {},
                   [this, &camera] { studio_.setTurntable(!camera.isTurntable()); },
                   [] { return true; },
                   [&camera] { return camera.isTurntable(); }});
}

// What the camera tool does in the middle of the picture, and the tool with it.
void MainWindow::makeDragActions() {
    auto& tool = tools_.get<CameraTool>();
    auto* uses = new QActionGroup(this);
    const auto add = [&](CameraTool::Use use, const char* name, const QString& text, const QString& tip) {
        actions_->addChoice(
            uses, {name,
                   nullptr,
                   text,
                   tip,
                   {},
                   [this, &tool, use] {
                       tool.setUse(use);
                       studio_.hand().take(tool);
                   },
                   {},
                   [this, &tool, use] { return &studio_.hand().tool() == &tool && tool.use() == use; }});
    };
    add(CameraTool::Use::Turn, "useTurn", tr("Drag to turn"), tr("The camera tool turns the volume"));
    add(CameraTool::Use::Move, "useMove", tr("Drag to move"), tr("The camera tool moves the picture"));
    add(CameraTool::Use::Zoom, "useZoom", tr("Drag to zoom"),
        tr("The camera tool comes nearer and steps back"));
}

// In the menu made last, which is the view's.
void MainWindow::makeCameraMenu() {
    QMenu* view = menuBar()->actions().constLast()->menu();
    QMenu* from = new QMenu(tr("Look from"), view);
    for (const StandardView& standard : CameraMotion::standardViews()) {
        from->QWidget::addAction(actions_->find("from." + standard.name));
    }
    from->addSeparator();
    from->QWidget::addAction(actions_->find("orthographic"));
    from->QWidget::addAction(actions_->find("turntable"));
    from->setToolTipsVisible(true);
    // After Reset and Fit.
    QAction* next = view->actions().at(2);
    view->insertMenu(next, from);
    for (const char* use : {"useTurn", "useMove", "useZoom"}) {
        view->insertAction(next, actions_->find(use));
    }
}

} // namespace vs::desktop
