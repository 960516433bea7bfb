// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/tool.h"
#include "render/slices/slice_view.h"
#include "studio/operations/operation.h"

#include <QObject>

#include <optional>

namespace vs::desktop {

class MeasureTool;
class PaintTool;
class SeedTool;
class StudioController;

// What pens and mouse do on slices: with the seed tool they seed (turned round, they remove), with the paint
// tool they correct the segment at work, with the measure tool they measure, with all others they lead the
// crosshair. A stroke is one operation, made when the pen is lifted.
class SlicePen : public QObject {
    Q_OBJECT

public:
    using Kind = render::SliceKind;

    SlicePen(StudioController& studio, SeedTool& seed, PaintTool& paint, MeasureTool& measure);

    // Places in mm on the picture (render::SliceGeometry). Reversed: the other button, or Ctrl. False: a
    // press that is not for the pen.
    bool press(Kind kind, glm::dvec2 place, bool isReversed, Qt::KeyboardModifiers modifiers);
    void move(Kind kind, glm::dvec2 place);
    void release(bool isDrag);
    // The pen moves over a slice with no button down.
    void hover(Kind kind, glm::dvec2 place);
    void cancel();
    // Whether the right button is the pen's too, as the eraser.
    [[nodiscard]] bool takesRightButton() const;

    // Whether a double click is the pen's too.
    [[nodiscard]] bool takesDoubleClick() const { return use() != Use::Crosshair; }

    // The stroke in hand, for previews. Radius of the pen as it would draw on this slice; nothing when it
    // leads the crosshair.
    struct Stroke {
        Kind kind = Kind::Axial;
        std::vector<glm::dvec2> places;
        double radiusMm = 0;
        Overlay::Tint tint = Overlay::Tint::Seed;
        int index = 0; // of the slice it was begun on
    };
    [[nodiscard]] const std::optional<Stroke>& stroke() const { return stroke_; }
    [[nodiscard]] std::optional<double> radiusMm(Kind kind) const;
    [[nodiscard]] Overlay::Tint tint(bool isReversed) const;

signals:
    void changed();

private:
    enum class Use { Crosshair, Seed, Paint, Measure };

    [[nodiscard]] Use use() const;
    void lead(Kind kind, glm::dvec2 place);
    [[nodiscard]] int indexOf(Kind kind) const; // of the slice that is shown
    [[nodiscard]] glm::dvec3 worldAt(Kind kind, glm::dvec2 place, int index) const;
    [[nodiscard]] studio::Trail trail() const;

    StudioController& studio_;
    SeedTool& seed_;
    PaintTool& paint_;
    MeasureTool& measure_;
    std::optional<Stroke> stroke_;
    bool isLeading_ = false;
    bool isMeasuring_ = false;
    int measuredSlice_ = 0; // what is drawn stays in it while others are looked at
    bool isReversed_ = false;
};

} // namespace vs::desktop
