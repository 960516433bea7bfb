// SPDX-License-Identifier: Apache-2.0
#include "panels/histogram_view.h"

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

HistogramView::HistogramView(QWidget* parent) : ChartWidget(parent) {
    setToolTip(tr("Drag the handles, or the band between them, to choose the displayed range.\n"
                  "Wheel: closer; Shift+wheel: along. Arrow keys: the band, with Ctrl its lower end, with "
                  "Shift its upper end."));
}

void HistogramView::setCounts(const std::vector<std::uint32_t>& counts, Range full, const QString& unit) {
    setAxis(full, unit);
    ChartWidget::setCounts(counts);
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

void HistogramView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFrame(painter);
    if (isEmpty()) {
        return;
    }
    const QRectF plot = area();
    const double lo = std::clamp(xOf(range_.lo), plot.left(), plot.right());
    const double hi = std::clamp(xOf(range_.hi), plot.left(), plot.right());
    QColor band = palette().color(QPalette::Link);
    band.setAlphaF(0.16F);
    painter.fillRect(QRectF(lo, plot.top(), std::max(hi - lo, 1.0), plot.height()), band);
    paintBars(painter, &range_);
    paintPart(painter, part_, partColour_);
    paintAxis(painter);
    const QColor ink = palette().color(QPalette::Text);
    for (const double end : {range_.lo, range_.hi}) {
        if (end < shown().lo || end > shown().hi) {
            continue;
        }
        const double x = xOf(end);
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(QPen(palette().color(QPalette::Base), 1)); // sets it off from bars
        painter.setBrush(ink);
        painter.drawRoundedRect(QRectF(x - kHandleWidth / 2, plot.center().y() - 11, kHandleWidth, 22), 3, 3);
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
    if (event->button() == Qt::LeftButton && !isEmpty()) {
        grip_ = gripAt(event->position().x());
        pressedValue_ = valueAt(event->position().x());
        pressedRange_ = range_;
        if (grip_ == Grip::Band) {
            setCursor(Qt::ClosedHandCursor);
        }
    }
}

void HistogramView::mouseMoveEvent(QMouseEvent* event) {
    if (grip_ == Grip::None) {
        const Grip over = isEmpty() ? Grip::None : gripAt(event->position().x());
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
        by = std::clamp(by, full().lo - from.lo, full().hi - from.hi); // the band keeps its width
        next = {from.lo + by, from.hi + by};
    } else if (grip == Grip::Lo) {
        next.lo = std::clamp(from.lo + by, full().lo, from.hi);
    } else {
        next.hi = std::clamp(from.hi + by, from.lo, full().hi);
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
    if (isEmpty() || (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const auto modifiers = event->modifiers();
    const Grip grip = modifiers.testFlag(Qt::ShiftModifier)     ? Grip::Hi
                      : modifiers.testFlag(Qt::ControlModifier) ? Grip::Lo
                                                                : Grip::Band;
    drag(grip, range_, event->key() == Qt::Key_Left ? -smallestStep() : smallestStep());
}

} // namespace vs::desktop
