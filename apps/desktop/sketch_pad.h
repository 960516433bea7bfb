// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operation.h"

#include <QPainterPath>
#include <QPointF>

#include <vector>

namespace vs::desktop {

// What a person draws on the picture, in logical pixels of the view. The raw pen points are kept unfiltered.
// Most shapes are one drag from press to release; a polyline is a click, or the end of a drag, for each
// corner, and ends with a click on its first corner, or twice on its last.
class SketchPad {
public:
    // With a stencil (any closed outline, y down) the drag says the box that it is fitted into.
    void begin(studio::Shape shape, QPointF at, const std::vector<glm::dvec2>& stencil = {});
    // The pen is here, pressed or, between a polyline's corners, above.
    void extend(QPointF to);
    // The pen was lifted here. False: it is a polyline, which goes on.
    bool end(QPointF at);
    void clear() { points_.clear(); }

    [[nodiscard]] bool isEmpty() const { return points_.empty(); }
    // Encloses something: at least a few pixels wide and high.
    [[nodiscard]] bool hasArea() const;
    // As drawn: an open line, or the shape in its box.
    [[nodiscard]] QPainterPath outline() const;
    // Closed; filled by the even-odd rule.
    [[nodiscard]] QPainterPath area() const;
    // The middle of the box around it: what follows the pen.
    [[nodiscard]] QPointF centre() const;
    // In the viewport's device pixels.
    [[nodiscard]] studio::Sketch sketch(glm::dvec2 devicePerLogical) const;

private:
    [[nodiscard]] QRectF box() const;
    [[nodiscard]] bool isDrawnByPoints() const;
    [[nodiscard]] std::vector<QPointF> fittedStencil() const;

    studio::Shape shape_ = studio::Shape::FreeForm;
    std::vector<QPointF> points_;
    std::vector<glm::dvec2> stencil_;
};

// A closed line through places in device pixels, in logical ones.
QPainterPath closedPath(const std::vector<glm::dvec2>& pixels, glm::dvec2 devicePerLogical);

} // namespace vs::desktop
