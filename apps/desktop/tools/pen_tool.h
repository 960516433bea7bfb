// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "tools/cut_tool.h"

#include "base/timer.h"
#include "studio/operations/operation.h"

#include <deque>
#include <optional>

namespace vs::desktop {

// First a mask is sketched; it then follows the pen, and pressing cuts, as deep as the pen is pressed. How it
// cuts is up to the tools made from this: drill and laser.
class PenTool : public CutTool {
    Q_OBJECT

public:
    // Depths in steps.
    struct Depths {
        double least = 0;
        double most = 0;
        double usual = 0;
    };

    PenTool(StudioController& studio, Depths depths);

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool canActOnSegment() const override { return true; }
    [[nodiscard]] Overlays overlays() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void leave() override;
    bool accept() override; // a polyline ends
    void clear() override;
    void viewResized() override;
    void advance() override;
    [[nodiscard]] bool isBehind() const override { return !waiting_.empty(); }
    [[nodiscard]] bool isBusy() const override {
        return state_ == State::Sketching || state_ == State::Cutting;
    }
    [[nodiscard]] bool isSketching() const override { return state_ == State::Sketching; }

    [[nodiscard]] const Depths& depths() const { return depths_; }
    // The depth at full pressure, in steps.
    [[nodiscard]] double depth() const { return depth_; }
    void setDepth(double steps);
    // Surfaces are seen again at every change of place or pressure, so that the pen works its way in.
    [[nodiscard]] bool keepsDigging() const { return keepsDigging_; }
    void setKeepsDigging(bool on);

protected:
    enum class State { Empty, Sketching, Ready, Cutting };

    struct Words {
        QString draw;   // the shape
        QString follow; // what the mask does
        QString cut;    // while it cuts
    };
    [[nodiscard]] virtual Words words() const = 0;
    // The operation without its pen points.
    [[nodiscard]] virtual studio::Operation operation(const studio::PenCut& cut) const = 0;
    // The mask where the pen is.
    [[nodiscard]] virtual QPainterPath maskAtPen() const;

    [[nodiscard]] State state() const { return state_; }
    [[nodiscard]] const SketchPad& pad() const { return pad_; }
    [[nodiscard]] bool isPenOver() const { return isPenOver_; }
    [[nodiscard]] QPointF penPosition() const { return pen_; }

private:
    [[nodiscard]] QString doing() const; // the hint, without what it works on
    void setState(State state);
    void takeMask();
    void beginCut(const Pen& pen);
    [[nodiscard]] double pressureOf(const Pen& pen) const;
    void ramp();
    void enqueue(const Pen& pen);
    void cut(double budgetMs);
    void straighten();
    void abandon();

    Depths depths_;
    double depth_;
    bool keepsDigging_ = false;
    SketchPad pad_;
    State state_ = State::Empty;
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
