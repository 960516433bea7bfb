// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/mask_tool.h"

#include "base/timer.h"

#include <deque>
#include <optional>

namespace vs::desktop {

// The mask follows the pen, and pressing cuts, as deep as the pen is pressed. How it cuts is up to the tools
// made from this: drill and laser.
class PenTool : public MaskTool {
    Q_OBJECT

public:
    // Depths in steps.
    struct Depths {
        double least = 0;
        double most = 0;
        double usual = 0;
    };

    PenTool(StudioController& studio, Depths depths);

    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void leave() override;
    void advance() override;
    [[nodiscard]] bool isBehind() const override { return state() == State::Cutting && !waiting_.empty(); }

    [[nodiscard]] const Depths& depths() const { return depths_; }
    // The depth at full pressure, in steps.
    [[nodiscard]] double depth() const { return depth_; }
    void setDepth(double steps);
    // Surfaces are seen again at every change of place or pressure, so that the pen works its way in.
    [[nodiscard]] bool keepsDigging() const { return keepsDigging_; }
    void setKeepsDigging(bool on);

protected:
    // The depth of the next stroke at full pressure, in steps.
    [[nodiscard]] virtual double strokeDepth() const { return depth_; }
    // The operation without its pen points.
    [[nodiscard]] virtual studio::Operation operation(const studio::PenCut& cut) const = 0;
    // Where the pen is.
    [[nodiscard]] QPainterPath mask() const override;
    [[nodiscard]] studio::Operation stroke(const studio::Sketch& mask,
                                           const studio::Canvas& canvas) const override;
    void begin(const Pen& pen) override;
    void lead(const Pen& pen) override;
    bool finish(const Pen& pen) override;
    void takeSketch() override;

    [[nodiscard]] bool isPenOver() const { return isPenOver_; }
    [[nodiscard]] QPointF penPosition() const { return pen_; }

private:
    [[nodiscard]] double pressureOf(const Pen& pen) const;
    void ramp();
    void cut(double budgetMs);
    void straighten();

    Depths depths_;
    double depth_;
    bool keepsDigging_ = false;
    QPointF pen_;
    bool isPenOver_ = false;
    std::optional<Pen> ramping_; // a mouse that is held down presses harder and harder
    Timer sincePress_;
    std::deque<sculpt::PenPoint> waiting_; // pen points the document has not seen yet
    sculpt::PenPoint done_;                // the last one it has seen, if it
    bool hasBegun_ = false;                // has seen any
    sculpt::PenPoint last_;
};

} // namespace vs::desktop
