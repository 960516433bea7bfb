// SPDX-License-Identifier: Apache-2.0
#include "panels/scrub_bar.h"

#include "parts/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QStyle>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vs::desktop {

namespace {
constexpr int kHandle = 14; // its width in the style sheet
} // namespace

ScrubBar::ScrubBar(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(22);
    // Keys; the pointer goes its own way below.
    connect(this, &QAbstractSlider::actionTriggered, this, [this] {
        const int wanted = std::clamp(sliderPosition(), minimum(), maximum());
        if (wanted != value()) {
            emit scrubbed(wanted);
        }
    });
}

void ScrubBar::setMarks(const std::vector<int>& marks) {
    if (marks_ != marks) {
        marks_ = marks;
        QStringList texts;
        std::ranges::transform(marks_, std::back_inserter(texts),
                               [](int mark) { return QString::number(mark); });
        setAccessibleDescription(texts.isEmpty() ? QString()
                                                 : tr("May have leaked after %1").arg(texts.join(", ")));
        setProperty("report", texts.join(' '));
        update();
    }
}

int ScrubBar::placeOf(int generation) const {
    return kHandle / 2 +
           QStyle::sliderPositionFromValue(minimum(), maximum(), generation, std::max(1, width() - kHandle));
}

int ScrubBar::valueAt(double x) const {
    constexpr int kReach = 5; // pixels that a mark draws the pointer from
    for (const int mark : marks_) {
        if (std::abs(x - placeOf(mark)) <= kReach) {
            return mark;
        }
    }
    const int span = std::max(1, width() - kHandle);
    return QStyle::sliderValueFromPosition(minimum(), maximum(), int(x) - kHandle / 2, span);
}

// Marks are flags below the groove, whose tips touch it.
void ScrubBar::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::kCutting);
    for (const int mark : marks_) {
        const QPointF tip(placeOf(mark) + 0.5, height() / 2.0 + 3);
        painter.drawPolygon(QPolygonF{{tip, tip + QPointF(4.5, 8), tip + QPointF(-4.5, 8)}});
    }
}

void ScrubBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        setSliderDown(true);
        setSliderPosition(valueAt(event->position().x()));
        emit scrubbed(sliderPosition());
    }
}

void ScrubBar::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) {
        const int wanted = valueAt(event->position().x());
        if (wanted != sliderPosition()) {
            setSliderPosition(wanted);
            emit scrubbed(wanted);
        }
    }
}

void ScrubBar::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && isSliderDown()) {
        setSliderDown(false);
        emit released();
    }
}

void ScrubBar::wheelEvent(QWheelEvent* event) { event->ignore(); }

void ScrubBar::keyReleaseEvent(QKeyEvent* event) {
    QSlider::keyReleaseEvent(event);
    if (!event->isAutoRepeat()) {
        emit released();
    }
}

} // namespace vs::desktop
