// SPDX-License-Identifier: Apache-2.0
#include "window/main_window.h"

#include "dialogs/export_dialog.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/history_panel.h"
#include "parts/icons.h"
#include "tools/camera_tool.h"
#include "tools/tool_box.h"
#include "view/view_widget.h"

#include <QActionGroup>
#include <QApplication>

namespace vs::desktop {

QAction* MainWindow::addAction(const ActionText& text, const std::function<void()>& run) {
    auto* action = new QAction(text.text, this);
    action->setObjectName(text.name);
    if (text.icon != nullptr) {
        action->setIcon(icon(text.icon));
    }
    const QString keys = text.shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? text.tip : text.tip + "  (" + keys + ")");
    action->setStatusTip(QString());
    action->setShortcut(text.shortcut);
    QWidget::addAction(action);
    connect(action, &QAction::triggered, this, run);
    actions_[text.name] = action;
    return action;
}

QAction* MainWindow::addChoice(QActionGroup* group, const ActionText& text,
                               const std::function<void()>& run) {
    QAction* action = addAction(text, run);
    action->setCheckable(true);
    group->addAction(action);
    return action;
}

void MainWindow::makeFileActions() {
    addAction({"open", "open", tr("Open"), tr("Open a volume or a session"), QKeySequence::Open},
              [this] { openFile(); });
    addAction({"openFolder", "folder", tr("DICOM"), tr("Open a folder of DICOM slices"), tr("Ctrl+Shift+O")},
              [this] { openFolder(); });
    addAction({"openLabels", "labels", tr("Open label map\u2026"),
               tr("Make segments of the labels of a label map on the volume's grid"), tr("Ctrl+L")},
              [this] { openLabels(); });
    addAction({"startScreen", "start", tr("Start"), tr("Close this and go back to the start screen"),
               QKeySequence::Close},
              [this] { leaveForStartScreen(); });
    addAction({"saveSession", "save", tr("Save"),
               tr("Save the session: everything done so far, to go on or replay"), QKeySequence::Save},
              [this] { saveSession(); });
    addAction(
        {"exportLabels", "labels", tr("Labels"), tr("Export the segmentation as a label map"), tr("Ctrl+E")},
        [this] { exportLabels(); });
    addAction({"export", "save", tr("Export\u2026"),
               tr("Surfaces, DICOM segmentations, the sculpted volume and tables, for other programs"),
               tr("Ctrl+Shift+E")},
              [this] {
                  auto* dialog =
                      new ExportDialog(studio_, studio_.preferences().recordings, suggestedName({}), this);
                  dialog->setAttribute(Qt::WA_DeleteOnClose);
                  dialog->open();
              });
    addAction({"screenshot", "screenshot", tr("Picture"), tr("Save the picture as PNG, at full quality"),
               tr("F12")},
              [this] { screenshot(); });
    addAction({"quit", "quit", tr("Quit"), tr("Leave Volume Studio"), tr("Ctrl+Q")}, [this] { close(); });
}

void MainWindow::makeEditActions() {
    addAction({"undo", "undo", tr("Undo"), tr("Take the last change back"), tr("Ctrl+Z")},
              [this] { studio_.editor().apply(studio::Undo{}); });
    addAction({"redo", "redo", tr("Redo"), tr("Do it again"), tr("Ctrl+Shift+Z")},
              [this] { studio_.editor().apply(studio::Redo{}); });
    addAction({"showHistory", "history", tr("History"), tr("All steps, to go to any of them"), tr("Ctrl+H")},
              [this] { history_->setVisible(action("showHistory")->isChecked()); })
        ->setCheckable(true);
    connect(history_, &QDockWidget::visibilityChanged, this,
            [this] { action("showHistory")->setChecked(!history_->isHidden()); });
    addAction({"unCut", "uncut", tr("Un-Cut"), tr("Clear all cuts"), tr("Ctrl+Shift+U")},
              [this] { studio_.editor().apply(studio::UnCut{}); });
    addAction({"reSeed", "reseed", tr("Re-Seed"), tr("Clear the segmentation"), tr("Ctrl+Shift+R")},
              [this] { studio_.editor().apply(studio::ReSeed{}); });
}

void MainWindow::makeViewActions() {
    addAction({"resetView", "reset", tr("Reset"), tr("Look at the face again, all of it"), tr("Home")},
              [this] { tools_.get<CameraTool>().reset(); });
    using render::Mode;
    auto* modes = new QActionGroup(this);
    const auto mode = [&](Mode value, const char* name, const char* iconName, const QString& text,
                          const QString& tip, const char* key) {
        addChoice(modes, {name, iconName, text, tip, QKeySequence(key)},
                  [this, value] { studio_.view().setMode(value); });
    };
    mode(Mode::Surface, "mode.surface", "surface", tr("Surface"), tr("The surface of the displayed range"),
         "1");
    mode(Mode::Mip, "mode.mip", "mip", tr("MIP"), tr("The greatest value along each ray"), "2");
    mode(Mode::XRay, "mode.xray", "xray", tr("X-ray"), tr("The sum of the values along each ray"), "3");
    mode(Mode::Overlay, "mode.overlay", "overlay", tr("Overlay"),
         tr("The segmentation in an X-ray of the rest"), "4");
    mode(Mode::Segment, "mode.segment", "segment", tr("Segment"),
         tr("The segmentation and the surface around it"), "5");
    mode(Mode::Volume, "mode.volume", "volume", tr("Volume"),
         tr("Everything that the transfer function shows, seen through"), "9");

    using field::SculptureView;
    auto* views = new QActionGroup(this);
    addChoice(views, {"viewCut", "cut", tr("Cut"), tr("What remains after cutting"), tr("6")},
              [this] { studio_.view().setSculptureView(SculptureView::Cut); });
    addChoice(views, {"viewProbe", "probe", tr("Probe"), tr("What has been cut out"), tr("7")},
              [this] { studio_.view().setSculptureView(SculptureView::Probe); });
    addChoice(views, {"viewWhole", "whole", tr("Whole"), tr("The whole volume, without cuts"), tr("8")},
              [this] { studio_.view().setSculptureView(SculptureView::Whole); });

    QAction* smooth = addAction(
        {"smoothSampling", nullptr, tr("Smooth sampling"),
         tr("Tricubic instead of trilinear: no facets where the picture is enlarged, but slower"),
         tr("Shift+S")},
        [this] {
            studio_.view().setSampling(action("smoothSampling")->isChecked() ? field::Sampling::Tricubic
                                                                             : field::Sampling::Trilinear);
        });
    smooth->setCheckable(true);

    addAction({"shadows", nullptr, tr("Shadows"), tr("Ambient occlusion and soft shadows"), tr("L")}, [this] {
        studio_.view().setShadows(action("shadows")->isChecked());
    })->setCheckable(true);

    addAction(
        {"hideAbove", nullptr, tr("Hide above"),
         tr("MIP, X-ray and overlay: hide values above the displayed range, instead of showing them as its "
            "upper end"),
         tr("Shift+A")},
        [this] { studio_.view().setHidesAbove(action("hideAbove")->isChecked()); })
        ->setCheckable(true);
    addAction({"tintSegments", nullptr, tr("Tint segments"),
               tr("MIP and X-ray: what is in a segment has the segment's colour"), tr("Shift+T")},
              [this] { studio_.view().setTintsSegments(action("tintSegments")->isChecked()); })
        ->setCheckable(true);

    QAction* annotations =
        addAction({"annotations", nullptr, tr("Annotations"),
                   tr("Scale bar and orientation marker over the view; saved pictures have none"), tr("A")},
                  [this] { view_->setAnnotated(action("annotations")->isChecked()); });
    annotations->setCheckable(true);
    annotations->setChecked(true);
}

void MainWindow::makeGrowthActions() {
    auto& growth = studio_.growth();
    addAction(
        {"playPause", "play", tr("Play or pause"), tr("Let the region grow, or pause it"), tr("Shift+G")},
        [&growth] { growth.isPlaying() ? growth.pause() : growth.play(); });
    addAction({"growBackwardKey", "backward", tr("Play backward"),
               tr("Play the growth backward, to its seeds"), tr("Shift+B")},
              [&growth] { growth.isBackward() ? growth.pause() : growth.playBackward(); });
    addAction({"addSegment", "add", tr("Add a segment"), tr("A fresh segment: new strokes go there"),
               tr("Ctrl+Shift+N")},
              [this] { studio_.segments().add(); });
    addAction({"growStepKey", "step", tr("Step"), tr("One generation further"), tr(".")},
              [&growth] { growth.step(); });
    addAction({"growBackKey", "back", tr("Backward"), tr("One generation back"), tr(",")},
              [&growth] { growth.stepBack(); });
    addAction(
        {"growToEndKey", "end", tr("To the end"), tr("Grow until nothing grows any more"), tr("Ctrl+G")},
        [&growth] { growth.toEnd(); });
}

} // namespace vs::desktop
