// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/marks/marks.h"
#include "marking/laying.h"
#include "sculpt/mask/outline.h"
#include "sculpt/surface/stroke.h"
#include "studio/operations/operation.h"
#include "studio/strokes/cutter.h"

#include <functional>
#include <optional>
#include <vector>

namespace vs::studio {

// One mark on its way: what is laid so far is in marks(). The surface is the one that was there when it was
// first looked at.
class MarkStroke {
public:
    using MakeFrame = std::function<render::Frame()>;

    // `operation` has its canvas set, whose frame `makeFrame` gives; `before` is what was marked already.
    MarkStroke(Cutter& cutter, MakeFrame makeFrame, field::SharedMarks before, const Mark& operation);

    // The pen of a free-form line has come here.
    void drawAt(const sculpt::PenPoint& pen);
    // All that the operation says, at once.
    void replay();

    [[nodiscard]] const Mark& operation() const { return operation_; }
    [[nodiscard]] const field::SharedMarks& marks() const { return now_; }
    [[nodiscard]] const field::SharedMarks& before() const { return before_; }

private:
    // A place of the pen in the picture, and how hard it is pressed there.
    struct Place {
        glm::dvec2 pixel{0};
        double pressure = 1;
    };
    using Line = std::vector<Place>;
    // The parts of a way that lie on one piece of the surface.
    using Paths = std::vector<std::vector<marking::PathPoint>>;

    [[nodiscard]] std::vector<std::optional<marking::ReliefPoint>>
    pick(const std::vector<glm::dvec2>& pixels);
    void followPen(const Line& line);
    void drawLine(const Line& line);
    void goTo(const Place& from, const Place& to);
    void layPiece(const Line& piece);
    [[nodiscard]] Paths pathsAlong(const Line& piece);
    [[nodiscard]] Paths dashed(const Paths& paths);
    [[nodiscard]] marking::PathPoint pathPoint(const glm::dvec3& world, double pressure) const;
    void layPaths(const Paths& paths);
    void drawArea();
    void drawArrow();
    void writeText();
    void show();
    [[nodiscard]] marking::Ground ground() const;
    [[nodiscard]] marking::Rim rim() const;
    [[nodiscard]] marking::Ink ink() const;

    Cutter* cutter_;
    MakeFrame makeFrame_;
    Mark operation_;
    render::ViewRays rays_;
    sculpt::MaskWindow picture_; // where something may be marked, pixels
    field::SharedMarks before_;
    field::SharedMarks now_;
    marking::MarkLayer layer_;
    marking::Relief relief_;
    std::optional<Place> last_; // of the pen
    double texelMm_ = 0;        // of marks, where the voxels lie now
    double dashMm_ = 0;         // of the line at work; 0: it is whole
    double travelledMm_ = 0;    // along it so far
};

} // namespace vs::studio
