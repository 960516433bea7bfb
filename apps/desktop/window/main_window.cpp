// SPDX-License-Identifier: Apache-2.0
#include "window/main_window.h"
#include "window/action_table.h"

#include "model/hand/pen_watch.h"
#include "model/hand/tool.h"
#include "model/keepers/recent_documents.h"
#include "model/keepers/recovery_keeper.h"
#include "model/keepers/thumbnail_keeper.h"
#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "model/texts/quantities.h"
#include "panels/growth_panel.h"
#include "panels/growth_rules_panel.h"
#include "panels/histogram_panel.h"
#include "panels/history_panel.h"
#include "panels/segment_edit_panel.h"
#include "panels/segment_numbers_panel.h"
#include "panels/tool_panel.h"
#include "parts/panel_parts.h"
#include "start/welcome_page.h"
#include "tools/camera_tool.h"
#include "tools/play_tool.h"
#include "tools/tool_box.h"
#include "view/camera_keys.h"
#include "view/play_strip.h"
#include "view/slice_canvas.h"
#include "view/touch_pad.h"
#include "view/view_grid.h"
#include "view/view_widget.h"
#include "window/hint_line.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace vs::desktop {

namespace {

constexpr int kProbeMs =
    120; // after the pen came to rest: often enough to read, rarely enough not to disturb
constexpr int kRateMs = 250;

// "L 12.3  P 4.5  S 30.2 mm": the patient's directions instead of signs.
QString patientPlace(glm::dvec3 lps, double stepMm) {
    const auto part = [stepMm](double value, const char* positive, const char* negative) {
        return QString("%1 %2").arg(value < 0 ? negative : positive).arg(placeText(value, stepMm));
    };
    return part(lps.x, "L", "R") + "  " + part(lps.y, "P", "A") + "  " + part(lps.z, "S", "I") + " " +
           placeUnit(stepMm);
}

} // namespace

MainWindow::MainWindow(StudioController& studio, ToolBox& tools, QWidget* parent)
    : QMainWindow(parent), studio_(studio), tools_(tools) {
    setObjectName("mainWindow");
    setWindowTitle(tr("Volume Studio"));
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu); // tool bars cannot be lost by a stray click
    thumbnails_ = new ThumbnailKeeper(studio_);
    recovery_ = new RecoveryKeeper(studio_);
    makeCentre();
    makeDock();
    makeStatusBar();
    actions_ = new ActionTable(*this, [this] { return isOpen(); });
    makeFileActions();
    makePictureActions();
    makeEditActions();
    makeViewActions();
    makeSliceActions();
    makeToolActions();
    makeGrowthActions();
    makePropertiesAction();
    makeHelpActions();
    makeDeveloperActions();
    makeMenus();
    makeToolBars();
    makeToolColumn();

    connect(&studio_.host(), &DocumentHost::changed, this, &MainWindow::refresh);
    connect(&studio_.hand(), &Hand::overlayChanged, this, &MainWindow::refreshHint);
    connect(&studio_.host(), &DocumentHost::messageChanged, this,
            [this] { message_->setText(studio_.host().message()); });
    connect(&studio_.host(), &DocumentHost::progress, this, &MainWindow::showProgress);
    connect(&studio_.host(), &DocumentHost::opened, this, &MainWindow::showView);
    // Later: whoever finds it is in the midst of something.
    connect(&studio_.host(), &DocumentHost::deviceLost, this, &MainWindow::startAgain, Qt::QueuedConnection);
    connect(&studio_.host(), &DocumentHost::openFailed, this, [this](const QString& message) {
        auto* box =
            new QMessageBox(QMessageBox::Warning, tr("Volume Studio"), message, QMessageBox::Ok, this);
        box->setObjectName("openFailed");
        box->button(QMessageBox::Ok)->setObjectName("closeOpenFailed");
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
    connect(&studio_.files(), &DocumentFiles::seriesWanted, this, &MainWindow::chooseSeries);
    connect(&studio_.files(), &DocumentFiles::volumeWanted, this, &MainWindow::askForVolume);
    studio_.files().searchIn(foldersUsedBefore);
    connect(view_, &ViewWidget::penMoved, this, [this] { probeTimer_.start(kProbeMs); });
    probeTimer_.setSingleShot(true);
    connect(&probeTimer_, &QTimer::timeout, this, &MainWindow::refreshProbe);
    connect(&rateTimer_, &QTimer::timeout, this, [this] {
        const double rate = studio_.picture().framesPerSecond();
        const auto refined = studio_.picture().refined();
        tellUnreadBricks();
        const std::size_t coming = studio_.picture().bricksComing();
        rate_->setText(coming > 0 ? tr("Reading bricks: %1").arg(coming)
                       : refined  ? tr("Refining %1 %").arg(int(100 * *refined))
                       : rate > 0 ? tr("%1 fps").arg(rate, 0, 'f', rate < 10 ? 1 : 0)
                                  : QString());
    });
    rateTimer_.setProperty(LongWork::kRunsMeanwhile, true);
    rateTimer_.start(kRateMs);
    refresh();
    showStartScreen();
}

void MainWindow::makeCentre() {
    centre_ = new QStackedWidget;
    welcome_ = named(new WelcomePage, "welcome", tr("Start screen"));
    connect(welcome_, &WelcomePage::openRequested, this, &MainWindow::openFile);
    connect(welcome_, &WelcomePage::openFolderRequested, this, &MainWindow::openFolder);
    connect(welcome_, &WelcomePage::blockRequested, this, &MainWindow::askForBlock);
    connect(welcome_, &WelcomePage::documentChosen, this, &MainWindow::open);
    connect(welcome_, &WelcomePage::recoverRequested, this, &MainWindow::recoverLost);
    welcome_->setSizePolicy(QSizePolicy::Ignored,
                            QSizePolicy::Preferred); // its width is not the view's least
    centre_->addWidget(welcome_);

    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    view_ = new ViewWidget(studio_, tools_);
    grid_ = new ViewGrid(studio_, tools_, view_);
    const auto* pen = new PenWatch(studio_.hand(), this);
    steerByFingers(*view_, studio_, *pen);
    for (SliceCanvas* canvas : grid_->findChildren<SliceCanvas*>()) {
        steerByFingers(*canvas, studio_, *pen);
    }
    new CameraKeys(*view_, studio_); // the view owns it
    column->addWidget(grid_, 1);
    column->addWidget(new PlayStrip(tools_.get<PlayTool>()));
    hint_ = named(new HintLine, "hint", tr("What to do next"));
    column->addWidget(hint_);
    centre_->addWidget(page);
    setCentralWidget(centre_);
}

void MainWindow::makeDock() {
    auto* dock = named(new QDockWidget(tr("Panels")), "panels", tr("Panels"));
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setTitleBarWidget(new QWidget(dock)); // none: the cards have their own titles
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 0, 8);
    column->setSpacing(8);
    column->addWidget(new HistogramPanel(studio_));
    column->addWidget(new ToolPanel(studio_, tools_));
    constexpr int takesRoom = 1000; // before the stretch below
    column->addWidget(new GrowthPanel(studio_), takesRoom);
    column->addWidget(new GrowthRulesPanel(studio_));
    column->addWidget(new SegmentEditPanel(studio_, tools_));
    column->addWidget(new SegmentNumbersPanel(studio_));
    column->addStretch(1);
    constexpr int kPanelWidth = 300;
    content->setFixedWidth(kPanelWidth);
    auto* scroll = new QScrollArea; // small screens
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // Tab goes to what is in it
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(kPanelWidth + 10); // room for the scroll bar
    dock->setWidget(scroll);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    history_ = new HistoryPanel(studio_);
    history_->hide(); // until it is asked for
}

void MainWindow::makeStatusBar() {
    statusBar()->setSizeGripEnabled(false);
    message_ = named(new QLabel, "message", tr("Message"));
    message_->setMinimumWidth(1);
    message_->setContentsMargins(8, 0, 8, 0);
    statusBar()->addWidget(message_, 1);
    addNoticesBadge();
    addJournalBadge();
    progress_ = named(new QProgressBar, "progress", tr("Progress"));
    progress_->setFixedWidth(150);
    progress_->setTextVisible(false);
    progress_->setMaximumHeight(12);
    progress_->hide();
    statusBar()->addPermanentWidget(progress_);
    giveUp_ = named(new QToolButton, "giveUp", tr("Give up"));
    giveUp_->setText(tr("Cancel"));
    giveUp_->setToolTip(tr("End what takes so long, and leave everything as it was (Esc)"));
    giveUp_->setFocusPolicy(Qt::NoFocus);
    giveUp_->setProperty("slim", true);
    giveUp_->setFixedHeight(message_->sizeHint().height()); // the bar stays as high as without it
    giveUp_->hide();
    connect(giveUp_, &QToolButton::clicked, &studio_.host(), &DocumentHost::giveUp);
    statusBar()->addPermanentWidget(giveUp_);
    const auto add = [this](const char* objectName, const QString& accessibleName) {
        auto* label = named(makeQuietLabel({}), objectName, accessibleName);
        label->setContentsMargins(10, 0, 10, 0);
        statusBar()->addPermanentWidget(label);
        return label;
    };
    probe_ = add("probe", tr("Value and place under the pen"));
    probe_->setProperty("quiet", false);
    duration_ = add("duration", tr("How long the last step took"));
    connect(&studio_.editor(), &Editor::done, this, &MainWindow::showDuration);
    volume_ = add("volume", tr("Size and type of the volume"));
    rate_ = add("rate", tr("Frame rate; at rest, how far the picture is refined"));
    rate_->setText(tr("Reading bricks: %1").arg(1000)); // the longest that it says
    rate_->setFixedWidth(rate_->sizeHint().width());
    rate_->clear();
    rate_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    device_ = add("device", tr("Graphics device"));
    const auto& device = studio_.host().gl().device();
    // "llvmpipe (LLVM 15.0.6, 256 bits)" is long; the whole of it is in the tooltip.
    device_->setText(QString::fromStdString(device.renderer).section(" (", 0, 0));
    device_->setToolTip(QString::fromStdString(device.renderer + ", OpenGL " + device.version));
}

void MainWindow::showDuration(double milliseconds) {
    duration_->setText(milliseconds < 1000 ? tr("%1 ms").arg(milliseconds, 0, 'f', milliseconds < 10 ? 1 : 0)
                                           : tr("%1 s").arg(milliseconds / 1000, 0, 'f', 1));
    duration_->setProperty("report", duration_->text());
}

void MainWindow::refresh() {
    actions_->refresh();
    if (const volume::Volume* volume = studio_.host().volume()) {
        setWindowTitle(QString::fromStdString(volume->name) + tr(" – Volume Studio"));
        const auto dims = volume->geometry.dims;
        volume_->setText(
            tr("%1 × %2 × %3  %4").arg(dims.x).arg(dims.y).arg(dims.z).arg(volume::name(volume->type)));
        showLevels();
    }
    refreshHint();
}

// What is worked on, where pictures show more than that.
void MainWindow::showLevels() {
    const glm::ivec3 finest = studio_.host().facts()->finestDims;
    if (finest == glm::ivec3(0)) {
        volume_->setToolTip({});
        return;
    }
    const int level = studio_.files().source().level.value_or(0);
    volume_->setText(volume_->text() + tr("  level %1").arg(level));
    volume_->setToolTip(tr("Edits are made on level %1. Pictures at rest show up to %2 × %3 × %4 voxels.")
                            .arg(level)
                            .arg(finest.x)
                            .arg(finest.y)
                            .arg(finest.z));
}

// Pictures show there what is worked on, which nobody would see.
void MainWindow::tellUnreadBricks() {
    const auto& failures = studio_.picture().brickFailures();
    for (; toldFailures_ < failures.size(); ++toldFailures_) {
        studio_.notices().add({failures[toldFailures_]});
    }
    toldFailures_ = failures.size(); // another document begins anew
}

void MainWindow::refreshHint() {
    hint_->say(studio_.host().isLoading() ? tr("Please wait…") : studio_.hand().tool().hint());
}

void MainWindow::refreshProbe() {
    const auto pen = view_->penPosition();
    if (!pen) {
        probe_->clear();
        return;
    }
    if (!studio_.isIdle()) {
        probeTimer_.start(kProbeMs); // later, at rest
        return;
    }
    const auto found = studio_.probe(*pen);
    if (!found) {
        probe_->setText(tr("nothing under the pen"));
        return;
    }
    showProbe(found->value, found->voxel, found->world);
}

void MainWindow::showProbe(double value, glm::dvec3 place, glm::dvec3 world) {
    // A face of the grid is half a voxel beyond the voxels that it belongs to.
    const glm::ivec3 last = studio_.host().geometry()->dims - 1;
    const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::round(place)), glm::ivec3(0), last);
    probe_->setText(tr("%1   at %2, %3, %4   %5")
                        .arg(value, 0, 'g', 6)
                        .arg(voxel.x)
                        .arg(voxel.y)
                        .arg(voxel.z)
                        .arg(patientPlace(world, studio_.host().geometry()->stepMm())));
}

void MainWindow::showProgress(int done, int total) {
    const bool isBusy = total == 0 || done < total;
    progress_->setRange(0, total); // 0: a bar without an end
    progress_->setValue(done);
    progress_->setVisible(isBusy);
    giveUp_->setVisible(isBusy);
    if (isBusy != isBusyCursor_) {
        isBusyCursor_ = isBusy;
        isBusy ? QApplication::setOverrideCursor(Qt::BusyCursor) : QApplication::restoreOverrideCursor();
    }
}

} // namespace vs::desktop
