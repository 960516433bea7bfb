// SPDX-License-Identifier: Apache-2.0
#include "panels/range_page.h"

#include "model/studio/studio_controller.h"
#include "panels/histogram_view.h"
#include "parts/panel_parts.h"
#include "studio/document/document_facts.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::desktop {

namespace {

constexpr int kRestMs = 150;     // until what is visible is counted
constexpr double kVisibleMs = 8; // of it at a time
constexpr double kTypable = 1e9; // beyond any volume: what is typed is answered, not cut off

QString written(double value) { return QString::number(value, 'g', 6); }

qulonglong total(const std::vector<std::uint32_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), qulonglong(0));
}

} // namespace

RangePage::RangePage(StudioController& studio) : studio_(studio) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    view_ = named(new HistogramView, "histogram", tr("Histogram with the displayed range"));
    column->addWidget(view_);
    column->addWidget(makeRangeRow());
    column->addWidget(makeSmoothingRow());
    note_ = named(makeQuietLabel({}), "rangeNote", tr("What is wrong with the number that was typed"));
    note_->setWordWrap(true);
    note_->hide();
    column->addWidget(note_);

    connect(view_, &HistogramView::rangeDragged, this, [this](Range range) {
        answer({});
        studio_.view().setRange(range);
    });
    connect(&studio_.host(), &DocumentHost::changed, this, &RangePage::refresh);
    countTimer_.setSingleShot(true);
    connect(&countTimer_, &QTimer::timeout, this, &RangePage::countVisible);
}

void RangePage::setColourStrip(const std::function<QColor(double)>& colourAt) {
    view_->setColourStrip(colourAt);
}

QWidget* RangePage::makeRangeRow() {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    lo_ = makeSpinBox("rangeLo", tr("Lower end of the displayed range"));
    hi_ = makeSpinBox("rangeHi", tr("Upper end of the displayed range"));
    unit_ = named(makeQuietLabel({}), "rangeUnit", tr("Unit of the volume's values"));
    logarithmic_ = named(new QToolButton, "histogramLog", tr("Logarithmic counts"));
    logarithmic_->setText(tr("log"));
    logarithmic_->setToolTip(
        tr("Heights by the logarithm of the counts: few voxels show beside millions of others"));
    logarithmic_->setCheckable(true);
    logarithmic_->setChecked(true);
    logarithmic_->setProperty("choice", true);
    logarithmic_->setFocusPolicy(Qt::TabFocus);
    row->addWidget(lo_, 1);
    row->addWidget(makeQuietLabel(tr("to")));
    row->addWidget(hi_, 1);
    row->addWidget(unit_);
    row->addWidget(logarithmic_);
    for (QDoubleSpinBox* box : {lo_, hi_}) {
        box->setMinimumWidth(72);
        connect(box, &QDoubleSpinBox::valueChanged, this, &RangePage::takeTyped);
    }
    connect(logarithmic_, &QToolButton::toggled, view_, &HistogramView::setLogarithmic);
    return holder;
}

QWidget* RangePage::makeSmoothingRow() {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    smoothing_ = makeSpinBox("surfaceSmoothing", tr("Smoothing of the displayed surface, in steps"));
    smoothing_->setRange(0, studio::kMostSurfaceSmoothing);
    smoothing_->setDecimals(2);
    smoothing_->setSingleStep(0.25);
    holder->setToolTip(tr("Smooths the values before the surface is looked for: takes the grain off skin. "
                          "Sections show the values as they are."));
    row->addWidget(makeQuietLabel(tr("Smooth surface")));
    row->addWidget(smoothing_, 1);
    row->addWidget(makeQuietLabel(tr("steps")));
    connect(smoothing_, &QDoubleSpinBox::valueChanged, this,
            [this](double sigma) { studio_.view().setSurfaceSmoothing(sigma); });
    return holder;
}

void RangePage::takeDocument() {
    const auto* document = studio_.host().document();
    const auto& volume = document->volume();
    const QString unit = QString::fromStdString(volume.unit);
    view_->setCounts(document->histogram(), volume.usual, unit);
    unit_->setText(unit);
    unit_->setVisible(!unit.isEmpty());
    const bool isWhole = volume.type != volume::ScalarType::Float32;
    view_->setQuantum(isWhole ? 1 : 0);
    // Floats: enough digits for a thousandth of the range.
    const double width = std::max(volume.usual.width(), 1e-9);
    const int decimals = isWhole ? 0 : std::clamp(int(std::ceil(3 - std::log10(width))), 0, 8);
    for (QDoubleSpinBox* box : {lo_, hi_}) {
        const QSignalBlocker blocker(box);
        box->setDecimals(decimals);
        box->setRange(-kTypable, kTypable);
        box->setSingleStep(isWhole ? 1 : width / 256);
    }
    answer({});
    refresh();
}

void RangePage::takeTyped() {
    const Range& now = studio_.view().shown().range;
    Range wanted{numberIn(*lo_, now.lo), numberIn(*hi_, now.hi)};
    const Range& full = view_->full();
    QString words;
    if (wanted.lo > wanted.hi) {
        words = tr("The ends are exchanged: the lower one comes first.");
        std::swap(wanted.lo, wanted.hi);
    }
    const Range taken{std::clamp(wanted.lo, full.lo, full.hi), std::clamp(wanted.hi, full.lo, full.hi)};
    if (!(taken == wanted)) {
        words = tr("%1 lies beyond the data, which go from %2 to %3.")
                    .arg(written(taken.hi == wanted.hi ? wanted.lo : wanted.hi), written(full.lo),
                         written(full.hi));
    }
    answer(words);
    studio_.view().setRange(taken);
    refresh(); // the numbers show what was taken, though the range may be the same as before
}

void RangePage::answer(const QString& words) {
    note_->setText(words);
    note_->setVisible(!words.isEmpty());
    if (!words.isEmpty()) {
        studio_.host().say(words);
    }
}

void RangePage::refresh() {
    const Range range = studio_.view().shown().range;
    view_->setRange(range);
    const double smoothing = studio_.view().shown().surfaceSmoothing;
    for (auto [box, value] :
         {std::pair{lo_, range.lo}, std::pair{hi_, range.hi}, std::pair{smoothing_, smoothing}}) {
        if (box->value() != value) { // setting it paints it again even so
            const QSignalBlocker blocker(box);
            box->setValue(value);
        }
    }
    if (!countTimer_.isActive()) {
        countTimer_.start(kRestMs);
    }
}

void RangePage::countVisible() {
    auto* document = studio_.host().document();
    if (document == nullptr) {
        return;
    }
    if (!studio_.isIdle() || studio_.host().facts()->isStrokeOpen()) {
        countTimer_.start(kRestMs);
        return;
    }
    const std::vector<std::uint32_t>* visible = nullptr;
    if (!studio_.host().workLong([&] { visible = document->visibleHistogram(kVisibleMs); })) {
        return;
    }
    if (visible == nullptr) {
        countTimer_.start(0);
        return;
    }
    const auto& all = document->histogram();
    view_->setVisibleCounts(*visible == all ? std::vector<std::uint32_t>() : *visible);
    view_->setProperty("report", tr("%1 of %2 voxels visible").arg(total(*visible)).arg(total(all)));
    view_->setAccessibleDescription(view_->property("report").toString());
}

} // namespace vs::desktop
