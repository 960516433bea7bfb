// SPDX-License-Identifier: Apache-2.0
#include "growth_panel.h"

#include "growth_controller.h"
#include "panel_parts.h"
#include "studio_controller.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

QLabel* addFigure(QGridLayout* grid, int row, const QString& text, const char* objectName) {
    grid->addWidget(makeQuietLabel(text), row, 0);
    auto* value = named(new QLabel, objectName, text);
    value->setAlignment(Qt::AlignRight);
    grid->addWidget(value, row, 1);
    return value;
}

} // namespace

GrowthPanel::GrowthPanel(StudioController& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    outer->addWidget(makeCard(tr("Segmentation"), card));

    card->addWidget(makeQuietLabel(tr("Intensities that may grow")));
    auto* row = new QHBoxLayout;
    lo_ = makeSpinBox("growthLo", tr("Lower end of the run's intensity range"));
    hi_ = makeSpinBox("growthHi", tr("Upper end of the run's intensity range"));
    row->addWidget(lo_, 1);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(hi_, 1);
    card->addLayout(row);
    connect(lo_, &QDoubleSpinBox::valueChanged, this, &GrowthPanel::takeRange);
    connect(hi_, &QDoubleSpinBox::valueChanged, this, &GrowthPanel::takeRange);

    card->addWidget(makePlayback());

    auto* options = new QHBoxLayout;
    autoStart_ = named(new QCheckBox(tr("Auto start")), "autoStart", tr("Start growing when seeds land"));
    autoStart_->setToolTip(tr("Start growing as soon as seeds are drawn"));
    autoStart_->setChecked(studio_.growth().isAutoStart());
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
    options->addWidget(autoStart_);
    options->addStretch(1);
    options->addWidget(speed_);
    card->addLayout(options);

    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(4);
    generation_ = addFigure(grid, 0, tr("Generation"), "generation");
    voxels_ = addFigure(grid, 1, tr("Voxels"), "voxels");
    millilitres_ = addFigure(grid, 2, tr("Volume"), "millilitres");
    card->addLayout(grid);

    connect(&studio_, &StudioController::opened, this, &GrowthPanel::takeDocument);
    connect(&studio_, &StudioController::changed, this, &GrowthPanel::refresh);
    setEnabled(false);
    refresh();
}

QWidget* GrowthPanel::makePlayback() {
    auto& growth = studio_.growth();
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    back_ = makeIconButton("back", "growBack", tr("Backward"),
                           tr("One generation back; hold to play backward ( , )"));
    play_ = makeIconButton("play", "growPlay", tr("Play"), tr("Let the region grow (Shift+G)"));
    pause_ = makeIconButton("pause", "growPause", tr("Pause"), tr("Pause growing (Shift+G)"));
    step_ = makeIconButton("step", "growStep", tr("Step"), tr("One generation further ( . )"));
    end_ = makeIconButton("end", "growEnd", tr("To the end"), tr("Grow until nothing grows any more"));
    back_->setAutoRepeat(true);
    step_->setAutoRepeat(true);
    connect(back_, &QToolButton::clicked, &growth, &GrowthController::stepBack);
    connect(play_, &QToolButton::clicked, &growth, &GrowthController::play);
    connect(pause_, &QToolButton::clicked, &growth, &GrowthController::pause);
    connect(step_, &QToolButton::clicked, &growth, &GrowthController::step);
    connect(end_, &QToolButton::clicked, &growth, &GrowthController::toEnd);
    for (QToolButton* button : {back_, play_, pause_, step_, end_}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    return holder;
}

void GrowthPanel::takeDocument() {
    const auto& volume = studio_.document()->volume();
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    const double width = std::max(volume.range.width(), 1e-9);
    const int decimals = isWhole ? 0 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8);
    for (QDoubleSpinBox* box : {lo_, hi_}) {
        const QSignalBlocker blocker(box);
        box->setDecimals(decimals);
        box->setRange(volume.range.lo, volume.range.hi);
        box->setSingleStep(isWhole ? 1 : width / 256);
    }
    setEnabled(true);
}

void GrowthPanel::takeRange() {
    const double lo = lo_->value();
    studio_.growth().setRange({std::min(lo, hi_->value()), std::max(lo, hi_->value())});
}

void GrowthPanel::refresh() {
    const auto& growth = studio_.growth();
    const auto status = growth.status();
    const bool canPlay = growth.canPlay() && !studio_.isLoading();
    play_->setEnabled(canPlay && !growth.isPlaying());
    pause_->setEnabled(growth.isPlaying());
    step_->setEnabled(canPlay && !growth.isPlaying());
    back_->setEnabled(canPlay && status.generation > 1);
    end_->setEnabled(canPlay);
    lo_->setEnabled(canPlay);
    hi_->setEnabled(canPlay);
    {
        // Until there are seeds, the range that a run would take: the displayed one.
        const Range range = status.hasSeeds ? status.range : studio_.view().range;
        const QSignalBlocker blockLo(lo_);
        const QSignalBlocker blockHi(hi_);
        lo_->setValue(range.lo);
        hi_->setValue(range.hi);
    }
    generation_->setText(status.hasSeeds ? tr("%1 of %2").arg(status.generation).arg(status.extent)
                                         : tr("no seeds yet"));
    voxels_->setText(grouped(status.voxels));
    millilitres_->setText(tr("%1 ml").arg(status.millilitres, 0, 'f', 2));
}

} // namespace vs::desktop
