// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/sketch_tool.h"

#include "studio/operations/operation.h"

#include <QTimer>

#include <optional>

namespace vs::desktop {

// First a mask is sketched, then the way that it goes: on the surface, in the plane across the view, or
// straight or in a helix along the view. Where the mask would go is shown before it is cut.
class SweepTool : public SketchTool<CutTool> {
    Q_OBJECT

public:
    enum class Way { Surface, ViewPlane, Line, Helix };

    // How a way is drawn: along the pen, or through corners that are clicked, straight or curved.
    enum class Line { FreeHand, Polyline, Spline };

    struct Settings {
        Way way = Way::Surface;
        Line line = Line::FreeHand;
        sculpt::FrameKind frame = sculpt::FrameKind::ParallelTransport;
        bool cutsAtPenUp = false; // else when told to
        // The length of a line and the height of a helix, in steps.
        double length = 40;
        double helixRadius = 12;
        double turns = 2;
        // For comparison (studio::Sweep).
        bool isRaw = false;
        sculpt::MaskFilter filter = {};
    };

    explicit SweepTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "sweep"; }
    [[nodiscard]] bool canActOnMaterial() const override { return true; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlays overlays() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;
    bool accept() override;
    void viewResized() override { abandon(); }
    [[nodiscard]] bool isBusy() const override { return isSketching(); }
    [[nodiscard]] bool isSketching() const override { return isDrawingMask() || state_ == State::DrawingWay; }

    [[nodiscard]] const Settings& settings() const { return settings_; }
    void set(const Settings& settings);
    // Whether a way is shown that can be cut.
    [[nodiscard]] bool canAccept() const { return state_ == State::Ready; }

protected:
    void takeSketch() override; // it is the mask

private:
    // Empty: there is no mask, or it is being sketched.
    enum class State { Empty, HasMask, DrawingWay, Ready };

    void setState(State state);
    [[nodiscard]] bool isDrawingMask() const { return SketchTool::isSketching(); }
    [[nodiscard]] bool isDrawn() const;
    [[nodiscard]] QString wayHint() const;
    [[nodiscard]] QPainterPath drawnWay() const;
    void prepare();
    void preview();
    void forgetOldView();
    void abandon();
    [[nodiscard]] std::optional<studio::Sweep> drawnSweep();

    Settings settings_;
    State state_ = State::Empty;
    SketchPad way_;
    std::optional<studio::Sweep> sweep_; // what would be cut, on the view that it was drawn on
    QPainterPath outlines_;
    QTimer calm_; // prepares again once the view is at rest
};

} // namespace vs::desktop
