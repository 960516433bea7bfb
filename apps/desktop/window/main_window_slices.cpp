// SPDX-License-Identifier: Apache-2.0
// Slices beside the 3D view: how they are arranged, how they look, and the brush that paints on them.
#include "model/document/view_model.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/library_texts.h"
#include "tools/paint_tool.h"
#include "tools/tool_box.h"
#include "view/view_grid.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include "render/slices/slice_windows.h"

#include <QActionGroup>
#include <QLabel>
#include <QMenu>
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
    makeSliceWindowActions();
    connect(grid_, &ViewGrid::arranged, this, &MainWindow::refreshSliceActions);
    connect(grid_, &ViewGrid::penMoved, this, &MainWindow::showSliceProbe);
    refreshSliceActions();
}

// Windows for slices of CT scans, the scan's own, and a tint of what the 3D picture shows: in the menu of the
// view, and where a slice is clicked on with the right button.
void MainWindow::makeSliceWindowActions() {
    ViewModel& view = studio_.view();
    auto* group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional); // none: one led by hand
    const auto add = [&](const std::string& name, const QString& text, const QString& tip,
                         const std::optional<Range>& window) {
        const auto show = [this, &view, window] {
            view.setSliceWindow(window);
            actions_->refresh(); // chosen again it is still the one
        };
        sliceWindows_.push_back(actions_->addChoice(
            group, {"sliceWindow." + name, nullptr, text, tip, {}, show, {}, [&view, window] {
                        return view.shown().sliceWindow == window;
                    }}));
    };
    add("automatic", tr("Automatic"), tr("The values of this scan from black to white"), {});
    for (const render::SliceWindow& window : render::kSliceWindows) {
        add(window.name, tr("%1 (CT)").arg(libraryText(window.title)),
            tr("CT: level %1, width %2")
                .arg(window.range.lo + 0.5 * window.range.width())
                .arg(window.range.width()),
            window.range);
    }
    sliceWindows_.push_back(actions_->add(
        {"tintSlices",
         nullptr,
         tr("Tint what is shown"),
         tr("Slices show in colour what the 3D picture shows: the displayed range or the transfer function"),
         tr("Shift+W"),
         [&view] { view.setTintsSlices(!view.shown().tintsSlices); },
         {},
         [&view] { return view.shown().tintsSlices; }}));
    grid_->offerOnSlices(sliceWindows_);
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
    QMenu* windows = view->addMenu(tr("Window of slices"));
    windows->setToolTipsVisible(true);
    windows->addActions(sliceWindows_);
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
