// SPDX-License-Identifier: Apache-2.0
#include "histogram_view.h"

#include "theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::desktop {

namespace {
constexpr double kHandleReach = 7; // pixels to either side in which a handle is caught
constexpr double kHandleWidth = 8;
} // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(110);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Drag the handles, or the band between them, to choose the displayed range"));
}

void HistogramView::setCounts(const std::vector<std::uint32_t>& counts, Range full) {
    counts_ = counts;
    full_ = full.width() > 0 ? full : Range{full.lo - 0.5, full.lo + 0.5};
    update();
}

void HistogramView::setPart(const std::vector<std::uint32_t>& counts, const QColor& colour) {
    part_ = counts;
    partColour_ = colour;
    update();
}

void HistogramView::setRange(Range range) {
    if (!(range == range_)) {
        range_ = range;
        update();
    }
}

QRectF HistogramView::plot() const {
    // Room for half a handle on both sides, and for focus.
    return QRectF(rect()).adjusted(kHandleWidth / 2 + 2, 3, -kHandleWidth / 2 - 2, -3);
}

double HistogramView::xOf(double value) const {
    const double t = std::clamp((value - full_.lo) / full_.width(), 0.0, 1.0);
    return plot().left() + t * plot().width();
}

double HistogramView::valueAt(double x) const {
    const double value = full_.lo + (x - plot().left()) / plot().width() * full_.width();
    return quantum_ > 0 ? std::round(value / quantum_) * quantum_ : value;
}

// On a logarithmic scale: tissue next to millions of air voxels would not show otherwise.
QPainterPath HistogramView::barsOf(const std::vector<std::uint32_t>& counts) const {
    const QRectF area = plot();
    const double most = std::log1p(double(*std::max_element(counts_.begin(), counts_.end())));
    const double width = area.width() / double(counts.size());
    QPainterPath bars(area.bottomLeft()); // one shape, so that no seams show between the bars
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double height = most > 0 ? std::log1p(double(counts[i])) / most * (area.height() - 6) : 0;
        bars.lineTo(area.left() + double(i) * width, area.bottom() - height);
        bars.lineTo(area.left() + double(i + 1) * width, area.bottom() - height);
    }
    bars.lineTo(area.bottomRight());
    return bars;
}

void HistogramView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? theme::kAccent : theme::kLine, 1));
    painter.setBrush(theme::kField);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    if (counts_.empty()) {
        painter.setPen(theme::kQuiet);
        painter.drawText(rect(), Qt::AlignCenter, tr("No volume"));
        return;
    }
    const QRectF area = plot();
    const double lo = xOf(range_.lo);
    const double hi = xOf(range_.hi);
    QColor band = theme::kAccent;
    band.setAlphaF(0.16F);
    painter.fillRect(QRectF(lo, area.top(), std::max(hi - lo, 1.0), area.height()), band);

    const QPainterPath bars = barsOf(counts_);
    painter.fillPath(bars, QColor(0x5a, 0x63, 0x6d));
    painter.save();
    painter.setClipRect(QRectF(lo, area.top(), std::max(hi - lo, 1.0), area.height()));
    painter.fillPath(bars, theme::kAccent);
    painter.restore();
    if (part_.size() == counts_.size()) {
        painter.fillPath(barsOf(part_), partColour_);
    }
    for (const double x : {lo, hi}) {
        painter.setPen(QPen(theme::kText, 1.5));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::kText);
        painter.drawRoundedRect(QRectF(x - kHandleWidth / 2, area.center().y() - 11, kHandleWidth, 22), 3, 3);
    }
}

HistogramView::Grip HistogramView::gripAt(double x) const {
    const double toLo = std::abs(x - xOf(range_.lo));
    const double toHi = std::abs(x - xOf(range_.hi));
    if (std::min(toLo, toHi) <= kHandleReach) {
        // Where both lie on one another, the side decides.
        return toLo < toHi || (toLo == toHi && x < xOf(range_.lo)) ? Grip::Lo : Grip::Hi;
    }
    return x > xOf(range_.lo) && x < xOf(range_.hi) ? Grip::Band : Grip::None;
}

void HistogramView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !counts_.empty()) {
        grip_ = gripAt(event->position().x());
        pressedValue_ = valueAt(event->position().x());
        pressedRange_ = range_;
        setCursor(grip_ == Grip::Band ? Qt::ClosedHandCursor : cursor().shape());
    }
}

void HistogramView::mouseMoveEvent(QMouseEvent* event) {
    if (grip_ == Grip::None) {
        const Grip over = counts_.empty() ? Grip::None : gripAt(event->position().x());
        setCursor(over == Grip::Band   ? Qt::OpenHandCursor
                  : over == Grip::None ? Qt::ArrowCursor
                                       : Qt::SizeHorCursor);
        return;
    }
    drag(grip_, pressedRange_, valueAt(event->position().x()) - pressedValue_);
}

void HistogramView::drag(Grip grip, Range from, double by) {
    Range next = from;
    if (grip == Grip::Band) {
        by = std::clamp(by, full_.lo - from.lo, full_.hi - from.hi); // the band keeps its width
        next = {from.lo + by, from.hi + by};
    } else if (grip == Grip::Lo) {
        next.lo = std::clamp(from.lo + by, full_.lo, from.hi);
    } else {
        next.hi = std::clamp(from.hi + by, from.lo, full_.hi);
    }
    if (!(next == range_)) {
        setRange(next);
        emit rangeDragged(next);
    }
}

void HistogramView::mouseReleaseEvent(QMouseEvent*) {
    const bool wasHeld = std::exchange(grip_, Grip::None) != Grip::None;
    unsetCursor();
    if (wasHeld) {
        emit released();
    }
}

void HistogramView::keyReleaseEvent(QKeyEvent* event) {
    QWidget::keyReleaseEvent(event);
    if (!event->isAutoRepeat()) {
        emit released();
    }
}

void HistogramView::keyPressEvent(QKeyEvent* event) {
    if (counts_.empty() || (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double bin = std::max(quantum_, full_.width() / double(counts_.size()));
    const double by = event->key() == Qt::Key_Left ? -bin : bin;
    drag(event->modifiers().testFlag(Qt::ShiftModifier) ? Grip::Hi : Grip::Band, range_,
         quantum_ > 0 ? std::round(by / quantum_) * quantum_ : by);
}

} // namespace vs::desktop
