// SPDX-License-Identifier: Apache-2.0
#include "histogram_panel.h"

#include "histogram_view.h"
#include "panel_parts.h"
#include "studio_controller.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

HistogramPanel::HistogramPanel(StudioController& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* card = nullptr;
    outer->addWidget(makeCard(tr("Displayed range"), card));
    view_ = named(new HistogramView, "histogram", tr("Histogram with the displayed range"));
    card->addWidget(view_);

    auto* row = new QHBoxLayout;
    lo_ = makeSpinBox("rangeLo", tr("Lower end of the displayed range"));
    hi_ = makeSpinBox("rangeHi", tr("Upper end of the displayed range"));
    row->addWidget(lo_, 1);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(hi_, 1);
    card->addLayout(row);

    connect(view_, &HistogramView::rangeDragged, &studio_, &StudioController::setRange);
    const auto typed = [this] {
        const double lo = lo_->value();
        studio_.setRange({std::min(lo, hi_->value()), std::max(lo, hi_->value())});
    };
    connect(lo_, &QDoubleSpinBox::valueChanged, this, typed);
    connect(hi_, &QDoubleSpinBox::valueChanged, this, typed);
    connect(&studio_, &StudioController::opened, this, &HistogramPanel::takeDocument);
    connect(&studio_, &StudioController::changed, this, &HistogramPanel::refresh);
    setEnabled(false);
}

void HistogramPanel::takeDocument() {
    const auto* document = studio_.document();
    const auto& volume = document->volume();
    view_->setCounts(document->histogram(), volume.range);
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    view_->setQuantum(isWhole ? 1 : 0);
    // Floats: enough digits for a thousandth of the range.
    const double width = std::max(volume.range.width(), 1e-9);
    const int decimals = isWhole ? 0 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8);
    for (QDoubleSpinBox* box : {lo_, hi_}) {
        const QSignalBlocker blocker(box);
        box->setDecimals(decimals);
        box->setRange(volume.range.lo, volume.range.hi);
        box->setSingleStep(isWhole ? 1 : width / 256);
    }
    setEnabled(true);
    refresh();
}

void HistogramPanel::refresh() {
    const Range range = studio_.view().range;
    view_->setRange(range);
    const QSignalBlocker blockLo(lo_);
    const QSignalBlocker blockHi(hi_);
    lo_->setValue(range.lo);
    hi_->setValue(range.hi);
}

} // namespace vs::desktop
