// SPDX-License-Identifier: Apache-2.0
// Rows of the table of actions: files, edits, the view and growth.
#include "dialogs/export_dialog.h"
#include "model/hand/tool.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/history_panel.h"
#include "studio/document/document_facts.h"
#include "tools/play_tool.h"
#include "tools/tool_box.h"
#include "view/view_widget.h"
#include "window/action_table.h"
#include "window/main_window.h"

#include <QActionGroup>
#include <QInputDialog>
#include <QLineEdit>

namespace vs::desktop {

bool MainWindow::isOpen() { return studio_.host().geometry() != nullptr && !studio_.host().isLoading(); }

bool MainWindow::hasVoxels() { return isOpen() && studio_.segments().hasVoxels(); }

void MainWindow::makeFileActions() {
    const auto canOpen = [this] { return !studio_.host().isLoading(); };
    actions_->add({"open", "open", tr("Open"), tr("Open a volume or a session"), QKeySequence::Open,
                   [this] { openFile(); }, canOpen});
    actions_->add({"playFile", "play", tr("Play a session\u2026"),
                   tr("Open a session and see it done step by step, as it was drawn"), tr("Ctrl+Alt+O"),
                   [this] { playFile(); }, canOpen});
    actions_->add({"playAgain", "play", tr("Play from the start"),
                   tr("See all that was done to this scan once more, step by step"), tr("Ctrl+Alt+P"),
                   [this] { playAgain(); },
                   [this] { return isOpen() && studio_.host().facts()->logged > 0; }});
    auto& player = tools_.get<PlayTool>();
    actions_->add({"playOrPause", "play", tr("Play or pause the session"),
                   tr("Let the session go on, or hold it"), Qt::Key_Space,
                   [&player] { player.isRunning() ? player.pause() : player.play(); },
                   [this, &player] { return isOpen() && player.hasSession() && !player.isAtEnd(); }});
    actions_->add({"openFolder", "folder", tr("DICOM"), tr("Open a folder of DICOM slices"),
                   tr("Ctrl+Shift+O"), [this] { openFolder(); }, canOpen});
    actions_->add({"newBlock", nullptr, tr("Sculpt from nothing…"),
                   tr("A block of a chosen size, to be carved or built up"), tr("Ctrl+Alt+N"),
                   [this] { askForBlock(); }, canOpen});
    actions_->add({"openLabels", "labels", tr("Open label map\u2026"),
                   tr("Make segments of the labels of a label map on the volume's grid"), tr("Ctrl+L"),
                   [this] { openLabels(); }});
    actions_->add({"startScreen", "start", tr("Start"), tr("Close this and go back to the start screen"),
                   QKeySequence::Close, [this] { leaveForStartScreen(); }});
    actions_->add({"saveSession", "save", tr("Save"),
                   tr("Save the session: everything done so far, to go on or replay"), QKeySequence::Save,
                   [this] { saveSession(); }});
    actions_->add({"saveSessionAs", "save", tr("Save as\u2026"), tr("Save the session in another file"),
                   tr("Ctrl+Shift+S"), [this] { saveSessionAs(); }});
    actions_->add({"exportLabels", "labels", tr("Labels"), tr("Export the segmentation as a label map"),
                   tr("Ctrl+E"), [this] { exportLabels(); }, [this] { return hasVoxels(); }});
    actions_->add({"export", "save", tr("Export\u2026"),
                   tr("Surfaces, DICOM segmentations, the sculpted volume and tables, for other programs"),
                   tr("Ctrl+Shift+E"), [this] { showExport(); }});
    actions_->add({"screenshot", "screenshot", tr("Picture"), tr("Save the picture as PNG, at full quality"),
                   tr("F12"), [this] { screenshot(); }});
    actions_->add({"quit", "quit", tr("Quit"), tr("Leave Volume Studio"), tr("Ctrl+Q"), [this] { close(); },
                   [] { return true; }});
}

void MainWindow::showExport() {
    auto* dialog = new ExportDialog(studio_, studio_.preferences().recordings, suggestedName({}), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::makeEditActions() {
    const auto apply = [this](const studio::Operation& operation) {
        return [this, operation] { studio_.editor().apply(operation); };
    };
    actions_->add({"undo", "undo", tr("Undo"), tr("Take the last change back"), tr("Ctrl+Z"),
                   apply(studio::Undo{}), [this] { return isOpen() && studio_.host().facts()->canUndo(); }});
    actions_->add({"redo", "redo", tr("Redo"), tr("Do it again"), tr("Ctrl+Shift+Z"), apply(studio::Redo{}),
                   [this] { return isOpen() && studio_.host().facts()->canRedo(); }});
    QAction* history = actions_->add(
        {"showHistory", "history", tr("History"), tr("All steps, to go to any of them"), tr("Ctrl+H"), {}});
    history->setCheckable(true);
    connect(history, &QAction::triggered, history_, &QWidget::setVisible);
    connect(history_, &QDockWidget::visibilityChanged, this,
            [this, history] { history->setChecked(!history_->isHidden()); });
    actions_->add({"addNote", "note", tr("Note\u2026"),
                   tr("Write a line into the history: why something was done, what to look at"), tr("Ctrl+N"),
                   [this] { askForNote(); }});
    actions_->add(
        {"unCut", "uncut", tr("Un-Cut"), tr("Clear all cuts"), tr("Ctrl+Shift+U"), apply(studio::UnCut{})});
    actions_->add({"reSeed", "reseed", tr("Re-Seed"), tr("Clear the segmentation"), tr("Ctrl+Shift+R"),
                   apply(studio::ReSeed{}), [this] { return hasVoxels(); }});
}

void MainWindow::askForNote() {
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName("note");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Note"));
    dialog->setLabelText(tr("A line for the history:"));
    dialog->setInputMode(QInputDialog::TextInput); // makes the line
    constexpr int seen = 60;                       // characters of it
    auto* edit = dialog->findChild<QLineEdit*>();
    edit->ensurePolished(); // its font is the theme's
    edit->setMinimumWidth(seen * edit->fontMetrics().averageCharWidth());
    const auto add = [this](const QString& text) {
        constexpr int mostBytes = 4; // of a character in UTF-8
        const QString line = text.simplified().left(studio::kMostNote / mostBytes);
        if (!line.isEmpty()) {
            studio_.editor().apply(studio::Note{line.toStdString()});
        }
    };
    connect(dialog, &QInputDialog::textValueSelected, this, add, Qt::QueuedConnection);
    dialog->open();
}

void MainWindow::makeViewActions() {
    makeCameraActions();
    makeModeActions();
    makeLookActions();
    QAction* annotations =
        actions_->add({"annotations",
                       nullptr,
                       tr("Annotations"),
                       tr("Scale bar and orientation marker over the view; saved pictures have none"),
                       tr("A"),
                       {}});
    annotations->setCheckable(true);
    annotations->setChecked(true);
    connect(annotations, &QAction::triggered, view_, &ViewWidget::setAnnotated);
}

// One of each group is checked, as the view has it.
void MainWindow::makeModeActions() {
    using render::Mode;
    auto* modes = new QActionGroup(this);
    const auto mode = [&](Mode value, const char* name, const QString& text, const QString& tip,
                          const char* key) {
        actions_->addChoice(modes, {"mode." + std::string(name),
                                    name,
                                    text,
                                    tip,
                                    QKeySequence(key),
                                    [this, value] { studio_.view().setMode(value); },
                                    {},
                                    [this, value] { return studio_.view().shown().mode == value; }});
    };
    mode(Mode::Surface, "surface", tr("Surface"), tr("The surface of the displayed range"), "1");
    mode(Mode::Mip, "mip", tr("MIP"), tr("The greatest value along each ray"), "2");
    mode(Mode::XRay, "xray", tr("X-ray"), tr("The sum of the values along each ray"), "3");
    mode(Mode::Overlay, "overlay", tr("Overlay"), tr("The segmentation in an X-ray of the rest"), "4");
    mode(Mode::Segment, "segment", tr("Segment"), tr("The segmentation and the surface around it"), "5");
    mode(Mode::Volume, "volume", tr("Volume"),
         tr("Everything that the transfer function shows, seen through"), "9");

    using field::SculptureView;
    auto* views = new QActionGroup(this);
    const auto sculpture = [&](SculptureView value, const char* name, const char* icon, const QString& text,
                               const QString& tip, const char* key) {
        actions_->addChoice(views, {name,
                                    icon,
                                    text,
                                    tip,
                                    QKeySequence(key),
                                    [this, value] { studio_.view().setSculptureView(value); },
                                    {},
                                    [this, value] { return studio_.view().shown().sculptureView == value; }});
    };
    sculpture(SculptureView::Cut, "viewCut", "cut", tr("Cut"), tr("What remains after cutting"), "6");
    sculpture(SculptureView::Probe, "viewProbe", "probe", tr("Probe"), tr("What has been cut out"), "7");
    sculpture(SculptureView::Whole, "viewWhole", "whole", tr("Whole"), tr("The whole volume, without cuts"),
              "8");
}

// Each changes one part of the view, and is checked as long as the view has it.
void MainWindow::makeLookActions() {
    auto& view = studio_.view();
    const auto add = [this](const char* name, const QString& text, const QString& tip, const char* key,
                            const std::function<void(bool)>& set, const std::function<bool()>& isSet) {
        QAction* action = actions_->add({name, nullptr, text, tip, QKeySequence(key), {}, {}, isSet});
        connect(action, &QAction::triggered, this, set);
    };
    add(
        "smoothSampling", tr("Smooth sampling"),
        tr("Tricubic instead of trilinear: no facets where the picture is enlarged, but slower"), "Shift+S",
        [&view](bool on) { view.setSampling(on ? field::Sampling::Tricubic : field::Sampling::Trilinear); },
        [&view] { return view.shown().sampling == field::Sampling::Tricubic; });
    add(
        "shadows", tr("Shadows"), tr("Ambient occlusion and soft shadows"), "L",
        [&view](bool on) { view.setShadows(on); }, [&view] { return view.shown().shadows; });
    add(
        "hideAbove", tr("Hide above"),
        tr("MIP, X-ray and overlay: hide values above the displayed range, instead of showing them as its "
           "upper end"),
        "Shift+A", [&view](bool on) { view.setHidesAbove(on); }, [&view] { return view.shown().hidesAbove; });
    add(
        "tintSegments", tr("Tint segments"),
        tr("MIP and X-ray: what is in a segment has the segment's colour"), "Shift+T",
        [&view](bool on) { view.setTintsSegments(on); }, [&view] { return view.shown().tintsSegments; });
    add(
        "voxelSegments", tr("Segments as voxels"),
        tr("Segments voxel by voxel, as they grow, instead of smooth"), "Shift+X",
        [&view](bool on) { view.setSmoothsSegments(!on); },
        [&view] { return !view.shown().smoothsSegments; });
    add(
        "invert", tr("Invert"), tr("MIP and X-ray: dark on light, as PET is often read; colours stay"),
        "Shift+I", [&view](bool on) { view.setInverted(on); }, [&view] { return view.shown().isInverted; });
}

void MainWindow::makeGrowthActions() {
    auto& growth = studio_.growth();
    const auto canPlay = [this, &growth] { return isOpen() && growth.canPlay(); };
    actions_->add({"playPause", "play", tr("Play or pause"), tr("Let the region grow, or pause it"),
                   tr("Shift+G"), [&growth] { growth.isPlaying() ? growth.pause() : growth.play(); },
                   canPlay});
    actions_->add({"growStopKey", "stop", tr("Stop"), tr("End growing: what has grown stays"), tr("Ctrl+."),
                   [&growth] { growth.stop(); }, [this, &growth] { return isOpen() && growth.canStop(); }});
    actions_->add({"growBackwardKey", "backward", tr("Play backward"),
                   tr("Play the growth backward, to its seeds"), tr("Shift+B"),
                   [&growth] { growth.isBackward() ? growth.pause() : growth.playBackward(); }, canPlay});
    actions_->add({"beforeLeak", nullptr, tr("Back to before the leak"),
                   tr("Show the last generation before the region may have leaked (marked on the scrub bar)"),
                   tr("Ctrl+Shift+B"), [&growth] { growth.backBeforeLeak(); },
                   [this, &growth] { return isOpen() && growth.generationBeforeLeak().has_value(); }});
    actions_->add({"addSegment", "add", tr("Add a segment"), tr("A fresh segment: new strokes go there"),
                   tr("Ctrl+Shift+N"), [this] { studio_.segments().add(); }});
    actions_->add({"growStepKey", "step", tr("Step"), tr("One generation further"), tr("."),
                   [&growth] { growth.step(); }, canPlay});
    actions_->add({"growBackKey", "back", tr("Backward"), tr("One generation back"), tr(","),
                   [&growth] { growth.takeBack(); }, canPlay});
    actions_->add({"growToEndKey", "end", tr("To the end"), tr("Grow until nothing grows any more"),
                   tr("Ctrl+G"), [&growth] { growth.toEnd(); }, canPlay});
}

} // namespace vs::desktop
