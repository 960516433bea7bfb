// SPDX-License-Identifier: Apache-2.0
#include "plane_view.h"

#include "render/function_edits.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::desktop {

namespace {
constexpr double kReach = 8;    // pixels in which a corner is caught
constexpr double kHandle = 3.5; // half of a corner's handle
constexpr double kBelow = 0.06; // of the magnitudes, shown below none: boxes of even places begin there
constexpr double kSmallest = 4; // pixels of a new shape
} // namespace

PlaneView::PlaneView(FunctionEditor& editor) : FunctionChart(editor, FunctionEditor::Kind::TwoD) {}

void PlaneView::forgetJoint() {
    joint_ = {};
    density_ = {};
    setCounts({});
}

void PlaneView::setJoint(const field::JointHistogram& joint) {
    joint_ = joint;
    std::vector<std::uint32_t> sums(std::size_t(joint.bins.x));
    for (std::size_t i = 0; i < joint.counts.size(); ++i) {
        sums[i % sums.size()] += joint.counts[i];
    }
    setCounts(sums); // how many columns there are, for steps
    makeDensity();
    update();
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

void PlaneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && !joint_.counts.empty()) {
        makeDensity();
    }
    FunctionChart::changeEvent(event);
}

glm::dvec2 PlaneView::perPixel() const {
    return {shown().width() / area().width(), (1 + kBelow) * joint_.gradients.hi / area().height()};
}

glm::dvec2 PlaneView::valueOf(QPointF place) const {
    return {shown().lo + (place.x() - area().left()) * perPixel().x,
            (area().bottom() - place.y()) * perPixel().y - kBelow * joint_.gradients.hi};
}

QPointF PlaneView::placeOf(glm::dvec2 value) const {
    return {xOf(value.x), area().bottom() - (value.y + kBelow * joint_.gradients.hi) / perPixel().y};
}

// Corners outside the chart are caught at its border.
std::optional<std::size_t> PlaneView::cornerAt(QPointF place) const {
    if (!chosen()) {
        return std::nullopt;
    }
    const auto* trapezoid = std::get_if<render::Trapezoid>(&function().shapes[*chosen()].form);
    if (trapezoid == nullptr) {
        return std::nullopt;
    }
    const auto corners = render::cornersOf(*trapezoid);
    std::optional<std::size_t> nearest;
    double least = kReach;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const QPointF at = placeOf(corners[i]);
        const QPointF held(std::clamp(at.x(), area().left(), area().right()),
                           std::clamp(at.y(), area().top(), area().bottom()));
        if (const double distance = QLineF(place, held).length(); distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

bool PlaneView::isPainting() const {
    return chosen() && std::holds_alternative<render::Painting>(function().shapes[*chosen()].form);
}

void PlaneView::addPart() {
    editor().begin();
    const double top = joint_.gradients.hi;
    const Range middle{shown().lo + 0.35 * shown().width(), shown().lo + 0.65 * shown().width()};
    const double centre = 0.5 * (middle.lo + middle.hi);
    const bool isTriangle = drawing_ == Drawing::Triangle;
    change([&](render::TransferFunction& f) {
        const auto colour = render::nextSafeColour(f);
        if (drawing_ == Drawing::Paint) {
            render::addShape(f, render::makePainting(full(), {-kBelow * top, top}, colour));
        } else {
            const Range base = isTriangle ? Range{centre, centre} : middle;
            render::addShape(
                f, {render::Trapezoid{base, middle, {0.3 * top, 0.7 * top}, {0.3, 0.3}}, colour, 0.5});
        }
    });
    editor().choose(kind(), 0);
}

void PlaneView::removeChosen() {
    const auto shape = chosen();
    if (shape) {
        change([&](render::TransferFunction& f) { render::removeShape(f, *shape); });
        editor().choose(kind(), std::nullopt);
    }
}

void PlaneView::moveChosen(glm::dvec2 steps) {
    const auto shape = *chosen();
    change([&](render::TransferFunction& f) {
        render::moveShape(f.shapes[shape], {steps.x * smallestStep(), steps.y * 0.01 * joint_.gradients.hi});
    });
}

void PlaneView::beginPainting() {
    if (!isPainting()) {
        addPart();
    }
    grip_ = Grip::Brush;
    last_ = pressed_;
    paintTo(pressed_);
}

void PlaneView::paintTo(QPointF place) {
    change([&](render::TransferFunction& f) {
        render::paintStroke(std::get<render::Painting>(f.shapes[*chosen()].form), valueOf(last_),
                            valueOf(place), brush_ * perPixel(), erases_);
    });
    last_ = place;
}

void PlaneView::mousePressEvent(QMouseEvent* event) {
    const bool isRight = event->button() == Qt::RightButton;
    if (isEmpty() || (event->button() != Qt::LeftButton && !isRight)) {
        return;
    }
    pressed_ = event->position();
    erases_ = isRight || event->modifiers().testFlag(Qt::ShiftModifier);
    editor().begin();
    before_ = function();
    if (drawing_ == Drawing::Paint) {
        beginPainting();
        return;
    }
    if (const auto corner = cornerAt(pressed_); corner && !isRight) {
        grip_ = Grip::Corner;
        corner_ = *corner;
        return;
    }
    const auto shape = render::shapeAt(function(), valueOf(pressed_));
    editor().choose(kind(), shape);
    if (isRight) {
        removeChosen();
    } else {
        grip_ = shape ? Grip::Shape : Grip::New;
    }
}

void PlaneView::drawNew(QPointF to) {
    const QRectF drawn = QRectF(pressed_, to).normalized();
    if (drawn.width() < kSmallest || drawn.height() < kSmallest) {
        return;
    }
    const glm::dvec2 lo = valueOf(drawn.bottomLeft());
    const glm::dvec2 hi = valueOf(drawn.topRight());
    const double centre = 0.5 * (lo.x + hi.x);
    change([&](render::TransferFunction& f) {
        f = before_;
        const Range top{lo.x, hi.x};
        const Range base = drawing_ == Drawing::Triangle ? Range{centre, centre} : top;
        render::addShape(f, {render::Trapezoid{base, top, {lo.y, hi.y}, {0.3, 0.3}},
                             render::nextSafeColour(before_), 0.5});
    });
    editor().choose(kind(), 0);
}

void PlaneView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF to = event->position();
    const glm::dvec2 by = valueOf(to) - valueOf(pressed_);
    switch (grip_) {
    case Grip::None:
        if (!isEmpty()) {
            setCursor(drawing_ == Drawing::Paint                             ? Qt::CrossCursor
                      : cornerAt(to)                                         ? Qt::SizeAllCursor
                      : render::shapeAt(function(), valueOf(to)).has_value() ? Qt::OpenHandCursor
                                                                             : Qt::CrossCursor);
        }
        return;
    case Grip::Corner:
        return change([&](render::TransferFunction& f) {
            f = before_;
            auto& trapezoid = std::get<render::Trapezoid>(f.shapes[*chosen()].form);
            render::moveCorner(trapezoid, corner_, render::cornersOf(trapezoid)[corner_] + by);
        });
    case Grip::Shape:
        return change([&](render::TransferFunction& f) {
            f = before_;
            render::moveShape(f.shapes[*chosen()], by);
        });
    case Grip::New:
        return drawNew(to);
    case Grip::Brush:
        return paintTo(to);
    }
}

void PlaneView::mouseReleaseEvent(QMouseEvent*) {
    grip_ = Grip::None;
    unsetCursor();
}

void PlaneView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && chosen() && drawing_ != Drawing::Paint) {
        emit colourWanted();
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
