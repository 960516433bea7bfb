// SPDX-License-Identifier: Apache-2.0
// Slices beside the 3D view: how they are arranged, how they look, and the brush that paints on them.
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "tools/paint_tool.h"
#include "tools/tool_box.h"
#include "view/view_grid.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include <QActionGroup>
#include <QLabel>
#include <QMenuBar>

namespace vs::desktop {

namespace {
// In the order of ViewGrid::Arrangement.
constexpr const char* kArrangements[] = {"only3D", "fourViews", "axialLarge", "coronalLarge",
                                         "sagittalLarge"};
} // namespace

void MainWindow::makeSliceActions() {
    auto* group = new QActionGroup(this);
    const auto add = [&](ViewGrid::Arrangement arrangement, const QString& text, const QString& tip,
                         const char* key) {
        actions_->addChoice(group, {kArrangements[int(arrangement)],
                                    nullptr,
                                    text,
                                    tip,
                                    QKeySequence(key),
                                    [this, arrangement] { grid_->arrange(arrangement); },
                                    {},
                                    [this, arrangement] { return grid_->arrangement() == arrangement; }});
    };
    using Arrangement = ViewGrid::Arrangement;
    add(Arrangement::Only3D, tr("3D only"), tr("The 3D view alone"), "F5");
    add(Arrangement::Four, tr("3D and three slices"), tr("The 3D view and three slices, all the same size"),
        "F6");
    add(Arrangement::Axial, tr("Axial large"), tr("The axial slice large, all else beside it"), "F7");
    add(Arrangement::Coronal, tr("Coronal large"), tr("The coronal slice large, all else beside it"), "F8");
    add(Arrangement::Sagittal, tr("Sagittal large"), tr("The sagittal slice large, all else beside it"),
        "F9");
    const auto hasSlices = [this] { return grid_->arrangement() != Arrangement::Only3D; };
    actions_->add(
        {"slices",
         "slices",
         tr("Slices"),
         tr("Axial, coronal and sagittal slices beside the 3D view"),
         tr("F4"),
         [this, hasSlices] { grid_->arrange(hasSlices() ? Arrangement::Only3D : Arrangement::Four); },
         {},
         hasSlices});
    auto& slices = studio_.slices();
    actions_->add({"smoothSlices",
                   nullptr,
                   tr("Smooth slices"),
                   tr("Slices interpolated between voxels, instead of every voxel as an area"),
                   {},
                   [&slices] { slices.setSmooth(!slices.isSmooth()); },
                   {},
                   [&slices] { return slices.isSmooth(); }});
    actions_->add({"resetSlices", nullptr, tr("All of each slice"), tr("Show all of each slice again"),
                   tr("Shift+Home"), [this] {
                       for (const auto kind : render::kSliceKinds) {
                           studio_.slices().showAll(kind);
                       }
                   }});
    constexpr double kPerKey = 1.15;
    actions_->add({"brushSmaller", nullptr, tr("Smaller brush"),
                   tr("A smaller brush to paint on slices with"), tr("["),
                   [this] { tools_.get<PaintTool>().resize(1 / kPerKey); }});
    actions_->add({"brushLarger", nullptr, tr("Larger brush"), tr("A larger brush to paint on slices with"),
                   tr("]"), [this] { tools_.get<PaintTool>().resize(kPerKey); }});
    connect(grid_, &ViewGrid::arranged, this, &MainWindow::refreshSliceActions);
    connect(grid_, &ViewGrid::penMoved, this, &MainWindow::showSliceProbe);
    refreshSliceActions();
}

// In the menu made last, which is the view's.
void MainWindow::makeSliceMenu() {
    QMenu* view = menuBar()->actions().constLast()->menu();
    view->addSeparator();
    for (const char* name :
         {"slices", kArrangements[0], kArrangements[1], kArrangements[2], kArrangements[3], kArrangements[4],
          "resetSlices", "smoothSlices", "brushSmaller", "brushLarger"}) {
        view->QWidget::addAction(actions_->find(name));
    }
}

void MainWindow::refreshSliceActions() {
    actions_->refresh();
    refreshHint(); // painting goes on slices
}

// At once: a slice's values need no look at the device.
void MainWindow::showSliceProbe(render::SliceKind kind, std::optional<glm::dvec2> place) {
    const auto found = place ? studio_.slices().probe(kind, *place) : std::nullopt;
    if (found) {
        showProbe(found->value, found->voxel, found->world);
    } else {
        probe_->clear();
    }
}

} // namespace vs::desktop
