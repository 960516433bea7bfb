// SPDX-License-Identifier: Apache-2.0
#include "hint_walk.h"

#include <QApplication>
#include <QImage>

namespace vs::desktop {

using studio::Shape;

void HintWalk::choose(Tool& tool) {
    w_.studio().hand().tool().clear();
    w_.studio().hand().take(tool);
    tool.setReversed(false);
    w_.settle();
}
void HintWalk::look(const std::string& state) {
    QCoreApplication::processEvents();
    look_(state);
}

// The shapes, drawn with one tool: up to where the sketch is finished.
void HintWalk::sketch(const std::string& tool, Shape shape, const char* name) {
    w_.studio().hand().setShape(shape);
    w_.studio().hand().tool().clear();
    mouse_.move(kA);
    look(tool + ", " + name + ": nothing drawn");
    mouse_.press(kA);
    look(tool + ", " + name + ": just pressed");
    for (const QPointF place : {kB, QPointF(0.52, 0.52), kC}) {
        mouse_.move(place);
    }
    look(tool + ", " + name + ": held");
    w_.studio().hand().tool().clear();
    mouse_.release(kC);
}
void HintWalk::polyline(const std::string& tool) {
    w_.studio().hand().setShape(Shape::Polyline);
    w_.studio().hand().tool().clear();
    mouse_.move(kA);
    look(tool + ", polyline: nothing drawn");
    mouse_.press(kA);
    look(tool + ", polyline: held on the first corner");
    mouse_.release(kA);
    look(tool + ", polyline: one corner");
    mouse_.press(kB);
    look(tool + ", polyline: held on the second corner");
    mouse_.release(kB);
    look(tool + ", polyline: two corners");
    mouse_.click(kC);
    mouse_.move(kMiddle);
    look(tool + ", polyline: three corners");
    mouse_.move(kA);
    look(tool + ", polyline: at its first corner");
    mouse_.press(kA);
    look(tool + ", polyline: held at its first corner");
}
void HintWalk::closePolyline() {
    mouse_.release(kA);
    w_.settle();
}
void HintWalk::dropPolyline() {
    w_.studio().hand().tool().clear();
    mouse_.release(kA);
}

void HintWalk::takeStencil() {
    QImage square(16, 16, QImage::Format_RGB32);
    square.fill(Qt::black);
    for (int n = 0; n < 64; ++n) {
        square.setPixel(4 + n % 8, 4 + n / 8, qRgb(255, 255, 255));
    }
    const auto path = StudioWindow::folder / "stencil.png";
    square.save(QString::fromStdString(path.string()));
    w_.studio().hand().setStencil(path);
}

} // namespace vs::desktop
