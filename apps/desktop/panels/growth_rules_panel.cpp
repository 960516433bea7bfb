// SPDX-License-Identifier: Apache-2.0
#include "panels/growth_rules_panel.h"

#include "model/segments/growth_controller.h"
#include "model/segments/segment_controller.h"
#include "model/segments/segment_measurer.h"
#include "model/studio/studio_controller.h"
#include "model/texts/texts.h"
#include "panels/histogram_view.h"
#include "parts/fold_card.h"
#include "parts/panel_parts.h"
#include "studio/document/document_facts.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

using studio::SetGrowthRules;

struct RowText {
    const char* name; // of the objects
    QString text;
    QString tip;
    std::optional<std::optional<Range>> SetGrowthRules::*member;
};

std::array<RowText, 3> rowTexts() {
    return {{{"ruleDifference", tr("Difference"),
              tr("Signed difference of intensity from a voxel to the next: new minus old"),
              &SetGrowthRules::difference},
             {"ruleGradient", tr("Gradient"), tr("Magnitude of the gradient, in intensity per mm"),
              &SetGrowthRules::gradient},
             {"ruleGradientDifference", tr("Gradient diff."),
              tr("Signed difference of the gradient's magnitude from a voxel to the next"),
              &SetGrowthRules::gradientDifference}}};
}

QByteArray sub(const char* name, const char* end) { return QByteArray(name) + end; }

} // namespace

GrowthRulesPanel::GrowthRulesPanel(StudioController& studio, QWidget* parent)
    : QWidget(parent), studio_(studio), card_(new FoldCard(tr("Growth rules"), "rulesFold")) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(card_);
    card_->content()->addWidget(makeRange());
    card_->content()->addWidget(makeRules());
    connect(card_, &FoldCard::toggled, this, [this](bool isOpen) {
        studio_.measurer().want(this, isOpen);
        showOwnValues();
    });
    connect(&studio_.measurer(), &SegmentMeasurer::changed, this, &GrowthRulesPanel::showOwnValues);
    connect(&studio_.host(), &DocumentHost::opened, this, &GrowthRulesPanel::takeDocument);
    connect(&studio_.host(), &DocumentHost::corrected, this, &GrowthRulesPanel::takeDocument);
    connect(&studio_.host(), &DocumentHost::changed, this, &GrowthRulesPanel::refresh);
    card_->content()->parentWidget()->setEnabled(false);
}

QWidget* GrowthRulesPanel::makeRange() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(makeQuietLabel(tr("Intensities that may grow")));
    histogram_ = named(new HistogramView, "growthHistogram", tr("Histogram with the range that may grow"));
    histogram_->setToolTip(tr("Drag the handles, or the band between them: what may grow. The bars in the "
                              "segment's colour are its own voxels"));
    histogram_->setMinimumHeight(84);
    column->addWidget(histogram_);
    auto* row = new QHBoxLayout;
    lo_ = makeSpinBox("growthLo", tr("Lower end of the run's intensity range"));
    hi_ = makeSpinBox("growthHi", tr("Upper end of the run's intensity range"));
    row->addWidget(lo_, 1);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(hi_, 1);
    column->addLayout(row);
    takesDisplayed_ = makeCheckBox(
        "takesDisplayedRange", tr("Strokes bring the displayed range"),
        tr("A stroke sets this range to the one that is displayed; off: strokes go by the range set here"),
        true);
    column->addWidget(takesDisplayed_);
    auto& growth = studio_.growth();
    connect(histogram_, &HistogramView::rangeDragged, this, [&growth](Range range) {
        SetGrowthRules rules;
        rules.range = range;
        growth.changeRules(rules, true);
    });
    connect(histogram_, &HistogramView::released, &growth, &GrowthController::releaseRules);
    connect(lo_, &QDoubleSpinBox::valueChanged, this, &GrowthRulesPanel::takeRange);
    connect(hi_, &QDoubleSpinBox::valueChanged, this, &GrowthRulesPanel::takeRange);
    connect(takesDisplayed_, &QCheckBox::toggled, this, [this](bool on) {
        if (!isShowing_) {
            studio_.growth().setTakesDisplayedRange(on);
        }
    });
    return holder;
}

QWidget* GrowthRulesPanel::makeRules() {
    auto* holder = new QWidget;
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    const auto texts = rowTexts();
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const RowText& text = texts[n];
        Row& row = rows_[n];
        row.member = text.member;
        row.isOn = makeCheckBox(text.name, text.text, text.tip, false);
        row.lo = makeSpinBox(sub(text.name, "Lo"), tr("%1: least").arg(text.text));
        row.hi = makeSpinBox(sub(text.name, "Hi"), tr("%1: most").arg(text.text));
        for (QDoubleSpinBox* box : {row.lo, row.hi}) {
            box->setMinimumWidth(56);
            connect(box, &QDoubleSpinBox::valueChanged, this, [this, n] { takeRow(rows_[n]); });
        }
        connect(row.isOn, &QCheckBox::toggled, this, [this, n] { takeRow(rows_[n]); });
        grid->addWidget(row.isOn, int(n), 0);
        grid->addWidget(row.lo, int(n), 1);
        grid->addWidget(row.hi, int(n), 2);
    }
    neighbours_ =
        new ChoiceRow({{"neighbours6", tr("6"), tr("Voxels that share a face")},
                       {"neighbours26", tr("26"), tr("Voxels that touch at an edge or a corner too")}},
                      0);
    connect(neighbours_, &ChoiceRow::chosen, this, [this](int choice) {
        SetGrowthRules rules;
        rules.connectivity = choice == 0 ? 6 : 26;
        studio_.growth().changeRules(rules, false);
    });
    grid->addWidget(makeQuietLabel(tr("Neighbours")), 3, 0);
    grid->addWidget(neighbours_, 3, 1, 1, 2);
    isLive_ = makeCheckBox("rulesLive", tr("Live: tightening takes away"),
                           tr("What could not be reached under tighter rules goes at once; off: rules hold "
                              "for what is still to grow"),
                           false);
    connect(isLive_, &QCheckBox::toggled, this, [this](bool on) {
        if (!isShowing_) {
            SetGrowthRules rules;
            rules.isLive = on;
            studio_.growth().changeRules(rules, false);
        }
    });
    grid->addWidget(isLive_, 4, 0, 1, 3);
    auto* fence =
        makeQuietLabel(tr("What was cut away fences it, as the view shows it (Cut, Probe, Whole)."));
    fence->setWordWrap(true);
    grid->addWidget(fence, 5, 0, 1, 3);
    return holder;
}

void GrowthRulesPanel::takeDocument() {
    isShowing_ = true;
    const auto* document = studio_.host().document();
    const auto& volume = document->volume();
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    const double width = std::max(volume.usual.width(), 1e-9);
    const int decimals = isWhole ? 0 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8);
    histogram_->setCounts(document->histogram(), volume.usual);
    histogram_->setQuantum(isWhole ? 1 : 0);
    for (QDoubleSpinBox* box : {lo_, hi_}) {
        box->setDecimals(decimals);
        box->setRange(volume.range.lo, volume.range.hi);
        box->setSingleStep(isWhole ? 1 : width / 256);
    }
    // Differences go both ways; gradients are per mm, and finer than whole numbers.
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        const bool isGradient = n > 0;
        const double most = isGradient ? width / volume.geometry.stepMm() : width;
        for (QDoubleSpinBox* box : {rows_[n].lo, rows_[n].hi}) {
            box->setDecimals(isGradient ? std::clamp(int(std::ceil(3 - std::log10(most))), 1, 8) : decimals);
            box->setRange(n == 1 ? 0 : -most, most);
            box->setSingleStep(isWhole && !isGradient ? 1 : most / 256);
        }
        rows_[n].lo->setValue(n == 1 ? 0 : -0.1 * most);
        rows_[n].hi->setValue(n == 1 ? most : 0.1 * most);
    }
    isShowing_ = false;
    card_->content()->parentWidget()->setEnabled(true);
    refresh();
}

void GrowthRulesPanel::takeRange() {
    if (!isShowing_) {
        SetGrowthRules rules;
        rules.range = Range{std::min(lo_->value(), hi_->value()), std::max(lo_->value(), hi_->value())};
        studio_.growth().changeRules(rules, false);
    }
}

void GrowthRulesPanel::takeRow(const Row& row) {
    if (isShowing_) {
        return;
    }
    const bool isOn = row.isOn->isChecked();
    const Range range{std::min(row.lo->value(), row.hi->value()), std::max(row.lo->value(), row.hi->value())};
    if (isOn || sender() == row.isOn) {
        SetGrowthRules rules;
        rules.*row.member = isOn ? std::optional<Range>(range) : std::nullopt;
        studio_.growth().changeRules(rules, false);
    }
}

void GrowthRulesPanel::refresh() {
    if (studio_.host().geometry() == nullptr || studio_.growth().areRulesPending()) {
        return;
    }
    isShowing_ = true;
    const auto rules = studio_.host().facts()->rules;
    const Range range = studio_.growth().range();
    histogram_->setRange(range);
    lo_->setValue(range.lo);
    hi_->setValue(range.hi);
    takesDisplayed_->setChecked(studio_.growth().takesDisplayedRange());
    const std::array<std::optional<Range>, 3> held{rules.difference, rules.gradient,
                                                   rules.gradientDifference};
    for (std::size_t n = 0; n < rows_.size(); ++n) {
        rows_[n].isOn->setChecked(held[n].has_value());
        if (held[n]) {
            rows_[n].lo->setValue(held[n]->lo);
            rows_[n].hi->setValue(held[n]->hi);
        }
        rows_[n].lo->setEnabled(held[n].has_value());
        rows_[n].hi->setEnabled(held[n].has_value());
    }
    neighbours_->choose(rules.connectivity == 6 ? 0 : 1);
    isLive_->setChecked(rules.isLive);
    isShowing_ = false;
}

void GrowthRulesPanel::showOwnValues() {
    const auto& working = studio_.segments().list().working();
    QColor colour =
        QColor::fromRgbF(float(working.colour.r), float(working.colour.g), float(working.colour.b));
    histogram_->setPart(studio_.measurer().histogram(), colour);
}

} // namespace vs::desktop
