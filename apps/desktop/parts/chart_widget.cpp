// SPDX-License-Identifier: Apache-2.0
#include "parts/chart_widget.h"

#include "image/axis.h"

#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {

constexpr double kSide = 6;            // room at both sides, for half a handle and the focus' frame
constexpr double kTop = 4;             // above the bars
constexpr double kStrip = 7;           // height of the strip of colours
constexpr double kAxis = 17;           // height of the numbers
constexpr double kTickText = 9;        // pixels of the numbers' font
constexpr double kClosest = 1.0 / 256; // of the axis

QFont tickFont(const QFont& font) {
    QFont small = font;
    small.setPixelSize(int(kTickText) + 1);
    return small;
}

QColor faded(QColor colour, double alpha) {
    colour.setAlphaF(float(alpha));
    return colour;
}

} // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ChartWidget::setAxis(Range full, const QString& unit) {
    full_ = full.width() > 0 ? full : Range{full.lo - 0.5, full.lo + 0.5};
    shown_ = full_;
    unit_ = unit;
    update();
}

void ChartWidget::setCounts(const std::vector<std::uint32_t>& counts) {
    counts_ = counts;
    visible_.clear();
    update();
}

void ChartWidget::setEmptyText(const QString& text) {
    emptyText_ = text;
    update();
}

void ChartWidget::setVisibleCounts(const std::vector<std::uint32_t>& counts) {
    if (visible_ != counts) {
        visible_ = counts;
        update();
    }
}

void ChartWidget::setLogarithmic(bool isLogarithmic) {
    isLogarithmic_ = isLogarithmic;
    update();
}

void ChartWidget::setColourStrip(const std::function<QColor(double)>& colourAt) {
    colourAt_ = colourAt;
    update();
}

QRectF ChartWidget::area() const {
    const double below = kAxis + (colourAt_ ? kStrip + 2 : 0);
    return QRectF(rect()).adjusted(kSide, kTop, -kSide, -below);
}

double ChartWidget::xOf(double value) const {
    return area().left() + (value - shown_.lo) / shown_.width() * area().width();
}

double ChartWidget::valueAt(double x) const {
    const double value = shown_.lo + (x - area().left()) / area().width() * shown_.width();
    return quantum_ > 0 ? std::round(value / quantum_) * quantum_ : value;
}

double ChartWidget::smallestStep() const {
    const double bin = full_.width() / double(std::max(counts_.size(), std::size_t(1)));
    return quantum_ > 0 ? std::max(quantum_, std::round(bin / quantum_) * quantum_) : bin;
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
    const double turns = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
    if (counts_.empty() || turns == 0) {
        event->ignore();
        return;
    }
    const double t = std::clamp((event->position().x() - area().left()) / area().width(), 0.0, 1.0);
    double width = shown_.width();
    double lo = shown_.lo;
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        lo -= turns * 0.1 * width;
    } else {
        width = std::clamp(width * std::pow(0.8, turns), kClosest * full_.width(), full_.width());
        lo += t * (shown_.width() - width); // what is under the pen stays there
    }
    lo = std::clamp(lo, full_.lo, full_.hi - width);
    shown_ = {lo, lo + width};
    event->accept();
    update();
    emit zoomed();
}

void ChartWidget::paintFrame(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF plot = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -(kAxis - 1));
    painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Link) : palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(plot, 5, 5);
    if (counts_.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(plot, Qt::AlignCenter, emptyText_);
    }
}

// One shape, so that no seams show between the bars.
QPainterPath ChartWidget::bars(const std::vector<std::uint32_t>& counts) const {
    const auto scaled = [this](double count) { return isLogarithmic_ ? std::log1p(count) : count; };
    const auto bin = full_.width() / double(counts.size());
    // The highest of those shown, so that going closer shows more of the small ones.
    std::uint32_t highest = 1;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const double lo = full_.lo + double(i) * bin;
        if (lo + bin > shown_.lo && lo < shown_.hi) {
            highest = std::max(highest, counts_[i]);
        }
    }
    const double perCount = (area().height() - 4) / scaled(highest);
    QPainterPath path(QPointF(xOf(full_.lo), area().bottom()));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double y = area().bottom() - std::min(scaled(counts[i]) * perCount, area().height());
        path.lineTo(xOf(full_.lo + double(i) * bin), y);
        path.lineTo(xOf(full_.lo + double(i + 1) * bin), y);
    }
    path.lineTo(QPointF(xOf(full_.hi), area().bottom()));
    return path;
}

void ChartWidget::paintBars(QPainter& painter, const Range* emphasised) const {
    const QColor plain = palette().color(QPalette::PlaceholderText);
    const QColor accent = palette().color(QPalette::Link);
    const bool hasTones = !visible_.empty();
    const auto paint = [&](const std::vector<std::uint32_t>& counts, double alpha) {
        const QPainterPath path = bars(counts);
        painter.save();
        painter.setClipRect(area());
        painter.fillPath(path, faded(plain, 0.62 * alpha));
        if (emphasised != nullptr) {
            const double lo = xOf(emphasised->lo);
            const double hi = xOf(emphasised->hi);
            painter.setClipRect(QRectF(lo, area().top(), std::max(hi - lo, 1.0), area().height()),
                                Qt::IntersectClip);
            painter.fillPath(path, palette().color(QPalette::Base)); // or the plain tone would shine through
            painter.fillPath(path, faded(accent, alpha));
        }
        painter.restore();
    };
    paint(counts_, hasTones ? 0.4 : 1);
    if (hasTones) {
        paint(visible_, 1);
        paintNote(painter, Qt::AlignRight, tr("pale: cut away"));
    }
}

void ChartWidget::paintPart(QPainter& painter, const std::vector<std::uint32_t>& counts,
                            const QColor& colour) const {
    if (counts.empty() || counts.size() != counts_.size()) {
        return;
    }
    painter.save();
    painter.setClipRect(area());
    painter.fillPath(bars(counts), colour);
    painter.restore();
}

void ChartWidget::paintNote(QPainter& painter, Qt::AlignmentFlag side, const QString& text) const {
    painter.setFont(tickFont(font()));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 6, metrics.height());
    const QPointF corner(side == Qt::AlignRight ? area().right() - size.width() : area().left(),
                         area().top());
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(palette().color(QPalette::Base), 0.75));
    painter.drawRoundedRect(QRectF(corner, size), 3, 3);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(corner, size), Qt::AlignCenter, text);
}

void ChartWidget::paintStrip(QPainter& painter, const QRectF& strip) const {
    const double ratio = devicePixelRatioF();
    const int columns = std::max(1, int(strip.width() * ratio));
    QImage image(columns, 1, QImage::Format_RGB32);
    for (int x = 0; x < columns; ++x) {
        const double value = shown_.lo + (x + 0.5) / columns * shown_.width();
        image.setPixelColor(x, 0, QColor(colourAt_(value).rgb()));
    }
    painter.drawImage(strip, image);
}

void ChartWidget::paintAxis(QPainter& painter) const {
    if (colourAt_) {
        paintStrip(painter, {area().left(), area().bottom() + 2, area().width(), kStrip});
    }
    painter.setFont(tickFont(font()));
    const QFontMetricsF metrics(painter.font());
    const double top = height() - kAxis + 1;
    double right = width() - 1;
    painter.setPen(palette().color(QPalette::PlaceholderText));
    if (!unit_.isEmpty()) {
        const double room = metrics.horizontalAdvance(unit_);
        painter.drawText(QRectF(right - room, top + 2, room, kAxis - 2), Qt::AlignCenter, unit_);
        right -= room + 5;
    }
    constexpr double kPixelsPerTick = 48;
    const int most = std::max(2, int(area().width() / kPixelsPerTick));
    for (const double value : image::roundTicks(shown_, most)) {
        const QString text = QString::fromStdString(image::tickLabel(value));
        const double x = xOf(value);
        painter.drawLine(QPointF(x, top - 0.5), QPointF(x, top + 2.5));
        const double room = metrics.horizontalAdvance(text);
        const double left = std::clamp(x - 0.5 * room, 0.0, width() - room);
        if (left + room <= right) {
            painter.drawText(QRectF(left, top + 2, room + 1, kAxis - 2), Qt::AlignCenter, text);
        }
    }
}

} // namespace vs::desktop
