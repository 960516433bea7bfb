// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <QPainterPath>
#include <QPointF>

#include <optional>
#include <vector>

namespace vs::desktop {

struct Pen;

// What a person draws on the picture, in logical pixels of the view. The raw pen points are kept unfiltered.
// Most shapes are one drag from press to release; a polyline is a click, or the end of a drag, for each
// corner. It ends with Enter, with a double click (or a second click on its last corner), or with a click on
// its first corner, which closes it.
class SketchPad {
public:
    // What it takes to be of use: an area that is enclosed, or a line, for which two corners are enough.
    enum class Needs { Area, Line };

    // With a stencil (any closed outline, y down) the drag says the box that it is fitted into.
    void begin(studio::Shape shape, QPointF at, const std::vector<glm::dvec2>& stencil = {},
               Needs needs = Needs::Area);
    // Pressed: begins a sketch, or goes on with a polyline.
    void press(const Pen& pen);
    // The pen is here, pressed or, between a polyline's corners, above.
    void extend(QPointF to);
    // The pen was lifted here. False: it is a polyline, which goes on.
    bool end(QPointF at);
    // Ends a polyline with the corners that it has. False: there is none under way that is of use.
    bool finish();
    void clear();

    [[nodiscard]] studio::Shape shape() const { return shape_; }
    [[nodiscard]] Needs needs() const { return needs_; }
    [[nodiscard]] bool isEmpty() const { return points_.empty(); }
    // The button or the pen is down.
    [[nodiscard]] bool isHeld() const { return isHeld_; }
    // A line for those that need no area: open, unless it ends on its first corner.
    [[nodiscard]] bool isLine() const;
    // How many corners a polyline has, without the place of the pen.
    [[nodiscard]] std::size_t corners() const { return points_.size(); }
    // Encloses something (at least a few pixels wide and high), or is a line.
    [[nodiscard]] bool isOfUse() const;
    // A click where the pen is would close the polyline; and whether there is any place where it would.
    [[nodiscard]] bool isAtFirstCorner() const { return canClose() && isNear(points_.front(), kCloses); }
    [[nodiscard]] bool canClose() const;
    // Letting go here would leave a polyline with the corners that it has.
    [[nodiscard]] bool isAtLastCorner() const;

    // The sketch as it is drawn: an open line, or the shape in its box. The line of a polyline goes on to the
    // pen.
    [[nodiscard]] QPainterPath outline() const;
    // What the sketch comes to if it ends now: closed and filled by the even-odd rule; a line as it is.
    [[nodiscard]] QPainterPath area() const;
    // The line from a polyline's last corner to the pen; empty when it has ended.
    [[nodiscard]] QPainterPath stretchToPen() const;
    // The ring around a polyline's first corner, in which a click closes it.
    [[nodiscard]] QPainterPath firstCorner() const;
    // The middle of the box around it: what follows the pen.
    [[nodiscard]] QPointF centre() const;
    // The sketch in the viewport's device pixels.
    [[nodiscard]] studio::Sketch sketch(glm::dvec2 devicePerLogical) const;

private:
    static constexpr double kCloses = 10;   // logical pixels from a polyline's first corner
    static constexpr double kSamePlace = 4; // as far as a hand moves between two clicks on one place

    [[nodiscard]] QRectF box() const;
    [[nodiscard]] bool isDrawnByPoints() const;
    [[nodiscard]] bool isPolyline() const { return shape_ == studio::Shape::Polyline; }
    [[nodiscard]] bool isNear(QPointF place, double pixels) const;
    [[nodiscard]] std::vector<QPointF> fittedStencil() const;

    studio::Shape shape_ = studio::Shape::FreeForm;
    Needs needs_ = Needs::Area;
    std::vector<QPointF> points_; // of a box its two corners, of a polyline those that were set
    std::optional<QPointF> pen_;  // while a polyline goes on
    bool isHeld_ = false;
    bool isDoubleClick_ = false; // the press that is held
    std::vector<glm::dvec2> stencil_;
};

// A closed line through places in device pixels, in logical ones.
QPainterPath closedPath(const std::vector<glm::dvec2>& pixels, glm::dvec2 devicePerLogical);

} // namespace vs::desktop
