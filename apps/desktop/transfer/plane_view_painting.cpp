// SPDX-License-Identifier: Apache-2.0
#include "transfer/plane_view.h"

#include "render/colours/function_edits.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kHandle = 3.5; // half of a corner's handle, in pixels
}

// By the logarithm of the counts, from the field's colour to the text's: light on dark or dark on light.
void PlaneView::makeDensity() {
    density_ = QImage(joint_.bins.x, joint_.bins.y, QImage::Format_RGB32);
    const auto most = *std::max_element(joint_.counts.begin(), joint_.counts.end());
    const double scale = 1 / std::log1p(double(std::max(most, 1U)));
    const QColor none = palette().color(QPalette::Base);
    const QColor all = palette().color(QPalette::Text);
    for (int y = 0; y < joint_.bins.y; ++y) {
        for (int x = 0; x < joint_.bins.x; ++x) {
            const auto count = joint_.counts[std::size_t(y) * std::size_t(joint_.bins.x) + std::size_t(x)];
            const double t = std::log1p(double(count)) * scale;
            const auto mixed = [t](int a, int b) { return int(a + (b - a) * t); };
            density_.setPixelColor(x, joint_.bins.y - 1 - y,
                                   QColor(mixed(none.red(), all.red()), mixed(none.green(), all.green()),
                                          mixed(none.blue(), all.blue())));
        }
    }
}

void PlaneView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFrame(painter);
    if (density_.isNull()) {
        return;
    }
    painter.save();
    painter.setClipRect(area());
    const QPointF lowest = placeOf({joint_.values.lo, joint_.gradients.lo});
    const QPointF highest = placeOf({joint_.values.hi, joint_.gradients.hi});
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(QPointF(lowest.x(), highest.y()), QPointF(highest.x(), lowest.y())), density_);
    painter.setOpacity(strength());
    paintFunction(painter);
    paintOutlines(painter);
    painter.restore();
    paintAxis(painter);
    paintNote(painter, Qt::AlignLeft,
              tr("gradient up to %1 per mm").arg(QString::number(joint_.gradients.hi, 'g', 3)));
}

// Colour and opacity of every other pixel, laid over the density.
void PlaneView::paintFunction(QPainter& painter) const {
    const render::FunctionSampler sampler(function());
    const QSize size = (area().size() / 2).toSize();
    QImage image(size, QImage::Format_ARGB32);
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x) {
            const glm::dvec2 value = valueOf(area().topLeft() + QPointF(2 * x + 1, 2 * y + 1));
            const glm::dvec4 seen = sampler.at(value.x, value.y);
            QColor colour = screenColour(render::colourFromLinear(glm::dvec3(seen)));
            colour.setAlphaF(float(seen.w > 0 ? 0.15 + 0.4 * std::sqrt(seen.w) : 0)); // faint ones show too
            image.setPixelColor(x, y, colour);
        }
    }
    painter.drawImage(area(), image);
}

void PlaneView::paintOutlines(QPainter& painter) const {
    const auto& shapes = function().shapes;
    for (std::size_t i = shapes.size(); i-- > 0;) {
        const auto* trapezoid = std::get_if<render::Trapezoid>(&shapes[i].form);
        if (trapezoid == nullptr) {
            continue;
        }
        const auto corners = render::cornersOf(*trapezoid);
        const bool isChosen = chosen() == i;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(isChosen ? palette().color(QPalette::Link) : screenColour(shapes[i].colour),
                            isChosen ? 2 : 1.2));
        painter.drawPolygon(
            QPolygonF{placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[3]), placeOf(corners[2])});
        if (isChosen) {
            painter.setBrush(palette().color(QPalette::Text));
            for (const glm::dvec2 corner : corners) {
                const QPointF at = placeOf(corner);
                const QPointF held(std::clamp(at.x(), area().left() + kHandle, area().right() - kHandle),
                                   std::clamp(at.y(), area().top() + kHandle, area().bottom() - kHandle));
                painter.drawRect(QRectF(held - QPointF(kHandle, kHandle), QSizeF(2 * kHandle, 2 * kHandle)));
            }
        }
    }
}

} // namespace vs::desktop
