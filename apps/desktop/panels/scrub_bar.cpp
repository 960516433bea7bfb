// SPDX-License-Identifier: Apache-2.0
#include "panels/scrub_bar.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>

#include <algorithm>

namespace vs::desktop {

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

int ScrubBar::valueAt(double x) const {
    constexpr int kHandle = 14; // its width in the style sheet
    const int span = std::max(1, width() - kHandle);
    return QStyle::sliderValueFromPosition(minimum(), maximum(), int(x) - kHandle / 2, span);
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
