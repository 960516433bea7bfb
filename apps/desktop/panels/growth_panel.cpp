// SPDX-License-Identifier: Apache-2.0
#include "panels/growth_panel.h"

#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/studio/studio_controller.h"
#include "panels/scrub_bar.h"
#include "panels/segment_table.h"
#include "parts/panel_parts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

namespace vs::desktop {

namespace {

QHBoxLayout* rowIn(QWidget* holder, int spacing) {
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(spacing);
    return row;
}

} // namespace

GrowthPanel::GrowthPanel(StudioController& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    outer->addWidget(makeCard(tr("Segments"), card));
    auto* table = named(new SegmentTable(studio_), "segments", tr("Segments"));
    card->addWidget(makeSearch(table));
    card->addWidget(table, 1);
    card->addWidget(makeListRow());
    card->addWidget(makePlayback());
    card->addWidget(makeScrubRow());
    card->addWidget(makeNotice());
    card->addWidget(makeOptions());
    card->addWidget(makeLimit());
    connect(&studio_.host(), &DocumentHost::opened, this, [this] { setEnabled(true); });
    connect(&studio_.host(), &DocumentHost::changed, this, &GrowthPanel::refresh);
    setEnabled(false);
    refresh();
}

// Of a long list.
QWidget* GrowthPanel::makeSearch(SegmentTable* table) {
    auto* search = named(new QLineEdit, "segmentSearch", tr("Search segments"));
    search->setPlaceholderText(tr("Search segments"));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, table, &SegmentTable::search);
    const auto show = [this, search, table] {
        search->setVisible(table->isLong());
        if (!table->isLong()) {
            search->clear();
        }
        // As much more as all rows of the list take.
        setMaximumHeight(QWIDGETSIZE_MAX);
        setMaximumHeight(sizeHint().height() + table->maximumHeight() - table->sizeHint().height());
    };
    search->hide();
    connect(table, &SegmentTable::lengthChanged, search, show, Qt::QueuedConnection);
    return search;
}

QWidget* GrowthPanel::makeListRow() {
    auto& segments = studio_.segments();
    auto* holder = new QWidget;
    auto* row = rowIn(holder, 4);
    auto* add = makeIconButton("add", "segmentAdd", tr("Add a segment"),
                               tr("A fresh segment: new strokes go there (Ctrl+Shift+N)"));
    remove_ = makeIconButton("remove", "segmentRemove", tr("Remove the segment"),
                             tr("Erase the segment at work and forget its name (Delete in the list)"));
    connect(add, &QToolButton::clicked, &segments, &SegmentController::add);
    connect(remove_, &QToolButton::clicked, &segments, &SegmentController::removeWorking);
    opacity_ = makeSlider("segmentOpacity", tr("Opacity of the segment at work, in percent"), 5, 100, 100);
    opacity_->setToolTip(tr("How much the segment at work hides"));
    connect(opacity_, &QSlider::valueChanged, this, [this](int percent) {
        if (isShowing_) {
            return;
        }
        const bool continues = opacity_->isSliderDown() && isOpacityDragged_;
        isOpacityDragged_ = opacity_->isSliderDown();
        studio_.segments().setOpacity(percent / 100.0, continues);
    });
    connect(opacity_, &QSlider::sliderReleased, this, [this] { isOpacityDragged_ = false; });
    row->addWidget(add);
    row->addWidget(remove_);
    row->addSpacing(8);
    row->addWidget(makeQuietLabel(tr("Opacity")));
    row->addWidget(withValue(opacity_, [](int v) { return tr("%1 %").arg(v); }), 1);
    return holder;
}

QWidget* GrowthPanel::makePlayback() {
    auto& growth = studio_.growth();
    auto* holder = new QWidget;
    auto* row = rowIn(holder, 2);
    back_ = makeIconButton("back", "growBack", tr("One generation back"),
                           tr("One generation back; hold for more ( , )"));
    backward_ = makeIconButton("backward", "growBackward", tr("Play backward"),
                               tr("Play backward, down to the seeds (Shift+B)"));
    pause_ = makeIconButton("pause", "growPause", tr("Pause"),
                            tr("Pause: what has grown stays, and play goes on from it (Shift+G)"));
    stop_ = makeIconButton("stop", "growStop", tr("Stop"),
                           tr("Stop: what has grown stays, and nothing goes on by itself"));
    play_ = makeIconButton("play", "growPlay", tr("Play"), tr("Let the region grow (Shift+G)"));
    step_ = makeIconButton("step", "growStep", tr("Step"), tr("One generation further; hold for more ( . )"));
    end_ =
        makeIconButton("end", "growEnd", tr("To the end"), tr("Grow until nothing grows any more (Ctrl+G)"));
    back_->setAutoRepeat(true);
    step_->setAutoRepeat(true);
    connect(back_, &QToolButton::clicked, &growth, &GrowthController::takeBack);
    connect(backward_, &QToolButton::clicked, &growth, &GrowthController::playBackward);
    connect(pause_, &QToolButton::clicked, &growth, &GrowthController::pause);
    connect(stop_, &QToolButton::clicked, &growth, &GrowthController::stop);
    connect(play_, &QToolButton::clicked, &growth, &GrowthController::play);
    connect(step_, &QToolButton::clicked, &growth, &GrowthController::step);
    connect(end_, &QToolButton::clicked, &growth, &GrowthController::toEnd);
    for (QToolButton* button : {back_, backward_, stop_, pause_, play_, step_, end_}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    return holder;
}

QWidget* GrowthPanel::makeScrubRow() {
    auto& growth = studio_.growth();
    auto* holder = new QWidget;
    auto* row = rowIn(holder, 8);
    scrub_ = named(new ScrubBar, "scrubBar", tr("Generation shown"));
    scrub_->setToolTip(tr("Drag through the generations; growing goes on from the one shown. Marks are where "
                          "it may have leaked: click one to go back to just before it"));
    connect(scrub_, &ScrubBar::scrubbed, &growth, &GrowthController::scrubTo);
    connect(scrub_, &ScrubBar::released, &growth, &GrowthController::endScrub);
    generation_ = named(new QLabel, "generation", tr("Generation"));
    generation_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    generation_->setMinimumWidth(76);
    row->addWidget(scrub_, 1);
    row->addWidget(generation_);
    return holder;
}

QWidget* GrowthPanel::makeNotice() {
    notice_ = new QWidget;
    auto* row = rowIn(notice_, 8);
    noticeText_ = named(new QLabel, "growthNotice", tr("Why growth has stopped"));
    noticeText_->setWordWrap(true);
    auto* goOn =
        named(new QPushButton(tr("Go on")), "growGoOn", tr("Let the region grow on, without a limit"));
    connect(goOn, &QPushButton::clicked, &studio_.growth(), &GrowthController::play);
    row->addWidget(noticeText_, 1);
    row->addWidget(goOn);
    notice_->hide();
    return notice_;
}

QWidget* GrowthPanel::makeOptions() {
    auto* holder = new QWidget;
    auto* row = rowIn(holder, 8);
    autoStart_ = makeCheckBox("autoStart", tr("Auto start"), tr("Start growing as soon as seeds are drawn"),
                              studio_.growth().isAutoStart());
    connect(autoStart_, &QCheckBox::toggled, &studio_.growth(), &GrowthController::setAutoStart);
    speed_ = named(new QSpinBox, "growthSpeed", tr("Generations per second"));
    speed_->setRange(0, 60);
    speed_->setSpecialValueText(tr("full speed"));
    speed_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    speed_->setAlignment(Qt::AlignRight);
    speed_->setSuffix(tr(" per s"));
    speed_->setToolTip(tr("Generations per second; 0 grows as fast as it can"));
    connect(speed_, &QAbstractSpinBox::editingFinished, speed_, &QWidget::clearFocus);
    connect(speed_, &QSpinBox::valueChanged, &studio_.growth(), &GrowthController::setSpeed);
    row->addWidget(autoStart_);
    row->addStretch(1);
    row->addWidget(speed_);
    return holder;
}

QWidget* GrowthPanel::makeLimit() {
    auto* holder = new QWidget;
    auto* row = rowIn(holder, 8);
    auto* limit = named(new QSpinBox, "growthLimit", tr("Size at which a first stroke stops, in percent"));
    limit->setRange(0, 100);
    limit->setSingleStep(5);
    limit->setSpecialValueText(tr("never"));
    limit->setButtonSymbols(QAbstractSpinBox::NoButtons);
    limit->setAlignment(Qt::AlignRight);
    limit->setSuffix(tr(" %"));
    limit->setKeyboardTracking(false);
    limit->setValue(studio_.growth().limitPercent());
    limit->setToolTip(
        tr("A segment's first stroke stops growing when it has so much of what is displayed; 0: "
           "never"));
    connect(limit, &QAbstractSpinBox::editingFinished, limit, &QWidget::clearFocus);
    connect(limit, &QSpinBox::valueChanged, &studio_, &StudioController::setFirstStrokePercent);
    row->addWidget(makeQuietLabel(tr("A first stroke stops at")));
    row->addStretch(1);
    row->addWidget(limit);
    return holder;
}

void GrowthPanel::refresh() {
    const auto& growth = studio_.growth();
    const auto status = growth.status();
    const bool canPlay = growth.canPlay() && !studio_.host().isLoading();
    play_->setEnabled(canPlay && (!growth.isPlaying() || growth.isBackward()));
    backward_->setEnabled(canPlay && status.generation > 1 && !growth.isBackward());
    pause_->setEnabled(growth.isPlaying());
    stop_->setEnabled(growth.canStop());
    step_->setEnabled(canPlay);
    back_->setEnabled(canPlay && status.generation > 1);
    end_->setEnabled(canPlay && !growth.isToEnd());
    scrub_->setEnabled(canPlay);
    if (!scrub_->isSliderDown()) {
        const QSignalBlocker blocker(scrub_);
        scrub_->setRange(status.hasSeeds ? 1 : 0, status.hasSeeds ? status.extent : 1);
        scrub_->setPageStep(std::max(1, status.extent / 10));
        scrub_->setValue(status.generation);
    }
    scrub_->setMarks(status.leaks);
    const bool hasStopped = growth.hasStoppedAtLimit();
    if (hasStopped) {
        noticeText_->setText(tr("Stopped at %1 % of what is displayed, %2 voxels")
                                 .arg(growth.limitPercent())
                                 .arg(grouped(status.voxels)));
    }
    notice_->setVisible(hasStopped);
    generation_->setText(status.hasSeeds ? tr("%1 of %2").arg(status.generation).arg(status.extent)
                                         : tr("no seeds yet"));
    remove_->setEnabled(studio_.segments().canRemove());
    if (!opacity_->isSliderDown()) {
        isShowing_ = true;
        opacity_->setValue(int(std::lround(100 * studio_.segments().list().working().opacity)));
        isShowing_ = false;
    }
}

} // namespace vs::desktop
