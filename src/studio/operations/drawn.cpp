// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/drawn.h"

#include "studio/operations/sketch.h"

namespace vs::studio {

namespace {

// One overload for each kind of drawing; all others draw nothing.
struct Drawing {
    Drawn operator()(const Peel& op) const { return masked(op.mask, op.canvas); }
    Drawn operator()(const Scissors& op) const { return masked(op.outline, op.canvas); }
    Drawn operator()(const FillHole& op) const { return masked(op.outline, op.canvas); }
    Drawn operator()(const Drill& op) const { return carried(op); }
    Drawn operator()(const Laser& op) const { return carried(op); }
    Drawn operator()(const Sweep& op) const {
        if (!op.path.isDrawn()) { // its mask and path are in steps and voxels
            return {};
        }
        Drawn drawn = masked(op.mask, op.canvas);
        drawn.way = op.path.stroke;
        return drawn;
    }
    Drawn operator()(const Seed& op) const { return strokes(op.strokes, op.widthPixels, op.canvas); }
    Drawn operator()(const Absorb& op) const { return strokes(op.strokes, op.widthPixels, op.canvas); }
    Drawn operator()(const Mark& op) const {
        return op.kind == Mark::Kind::Area ? masked(op.sketch, op.canvas)
                                           : strokes({op.sketch}, 1, op.canvas);
    }
    Drawn operator()(const BrushSegment& op) const { return of(op.stroke); }
    Drawn operator()(const Fill& op) const { return of(op.stroke); }
    Drawn operator()(const Unfill& op) const { return of(op.stroke); }
    template <typename Op>
    Drawn operator()(const Op&) const {
        return {};
    }

private:
    template <typename Stroke>
    [[nodiscard]] Drawn of(const Stroke& stroke) const {
        return std::visit([this](const auto& op) { return (*this)(op); }, stroke);
    }
    static Drawn masked(const Sketch& mask, const std::optional<Canvas>& canvas) {
        return {.areas = {outlineOf(mask)}, .canvas = canvas};
    }
    static Drawn carried(const PenCut& op) {
        Drawn drawn = masked(op.mask, op.canvas);
        for (const sculpt::PenPoint& pen : op.stroke) {
            drawn.way.push_back(pen.pixel);
        }
        return drawn;
    }
    static Drawn strokes(const std::vector<Sketch>& sketches, double width,
                         const std::optional<Canvas>& canvas) {
        Drawn drawn{.lineWidth = width, .canvas = canvas};
        for (const Sketch& sketch : sketches) {
            const bool isOpen = sketch.shape == Shape::FreeForm || sketch.shape == Shape::Polyline;
            (isOpen ? drawn.lines : drawn.areas).push_back(isOpen ? sketch.points : outlineOf(sketch));
        }
        return drawn;
    }
};

} // namespace

Drawn::Line Drawn::areaAt(const Line& area, glm::dvec2 place) const {
    Line moved = area;
    const glm::dvec2 shift = place - centreOf(area);
    for (glm::dvec2& corner : moved) {
        corner += shift;
    }
    return moved;
}

Drawn drawnFor(const Operation& operation) { return std::visit(Drawing(), operation); }

} // namespace vs::studio
