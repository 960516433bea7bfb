// SPDX-License-Identifier: Apache-2.0
#include "mouse.h"

#include <QTest>
#include <QWindow>

namespace vs::desktop {

QPoint Mouse::inWindow(QPointF place) const {
    QWidget& view = w_.view();
    const QPoint inView(int(place.x() * view.width()), int(place.y() * view.height()));
    return view.mapTo(&w_.window(), inView);
}

void Mouse::move(QPointF place) { QTest::mouseMove(w_.window().windowHandle(), inWindow(place)); }

void Mouse::press(QPointF place) {
    move(place);
    QTest::mousePress(w_.window().windowHandle(), Qt::LeftButton, {}, inWindow(place));
}

void Mouse::release(QPointF place) {
    move(place);
    QTest::mouseRelease(w_.window().windowHandle(), Qt::LeftButton, {}, inWindow(place));
}

void Mouse::click(QPointF place) {
    press(place);
    release(place);
}

void Mouse::doubleClick(QPointF place) {
    move(place);
    QTest::mouseDClick(w_.window().windowHandle(), Qt::LeftButton, {}, inWindow(place));
}

void Mouse::drag(const std::vector<QPointF>& way) {
    press(way.front());
    for (const QPointF place : way) {
        move(place);
    }
    release(way.back());
}

} // namespace vs::desktop
