// SPDX-License-Identifier: Apache-2.0
#include "transfer/plane_view.h"

#include "render/colours/function_edits.h"

#include <QEvent>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kGripReach = 8; // pixels in which a corner is caught
constexpr double kBelow = 0.06;  // of the magnitudes, shown below none: boxes of even places begin there
constexpr double kSmallest = 4;  // pixels of a new shape
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
    double least = kGripReach;
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

} // namespace vs::desktop
