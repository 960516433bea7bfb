// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operation.h"

#include <QPainterPath>
#include <QPointF>

#include <vector>

namespace vs::desktop {

// What a person draws on the picture, in logical pixels of the view. The raw pen points are kept unfiltered.
class SketchPad {
public:
    void begin(studio::Shape shape, QPointF at);
    void extend(QPointF to);
    void clear() { points_.clear(); }

    [[nodiscard]] bool isEmpty() const { return points_.empty(); }
    // Encloses something: at least a few pixels wide and high.
    [[nodiscard]] bool hasArea() const;
    // As drawn: an open line, or the ellipse in its box.
    [[nodiscard]] QPainterPath outline() const;
    // Closed; filled by the even-odd rule.
    [[nodiscard]] QPainterPath area() const;
    // The middle of the box around it: what follows the pen.
    [[nodiscard]] QPointF centre() const;
    // In the viewport's device pixels.
    [[nodiscard]] studio::Sketch sketch(glm::dvec2 devicePerLogical) const;

private:
    [[nodiscard]] QRectF box() const;

    studio::Shape shape_ = studio::Shape::FreeForm;
    std::vector<QPointF> points_;
};

// A closed line through places in device pixels, in logical ones.
QPainterPath closedPath(const std::vector<glm::dvec2>& pixels, glm::dvec2 devicePerLogical);

} // namespace vs::desktop
