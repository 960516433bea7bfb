// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sketch_pad.h"
#include "tool.h"

#include "sculpt/stroke.h"

#include <deque>

namespace vs::desktop {

class StudioController;

// First a mask is sketched; it then follows the pen, and pressing drills along the view through it, as deep
// as the pen is pressed.
class DrillTool : public Tool {
    Q_OBJECT

public:
    static constexpr double kLeastDepth = 8;
    static constexpr double kMostDepth = 12;

    explicit DrillTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "drill"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Overlay overlay() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void leave() override;
    void clear() override;
    void viewResized() override;
    void advance() override;
    [[nodiscard]] bool isBusy() const override {
        return state_ == State::Sketching || state_ == State::Drilling;
    }
    [[nodiscard]] bool isSketching() const override { return state_ == State::Sketching; }

    // Steps at full pressure.
    [[nodiscard]] double depth() const { return depth_; }
    void setDepth(double steps) { depth_ = steps; }

private:
    enum class State { Empty, Sketching, Ready, Drilling };

    void setState(State state);
    void enqueue(const Pen& pen);
    void drill(double budgetMs);
    void abandon();

    StudioController& studio_;
    SketchPad pad_;
    State state_ = State::Empty;
    double depth_ = 10;
    QPointF pen_;
    bool isPenOver_ = false;
    std::deque<sculpt::PenPoint> waiting_; // pen points the document has not seen yet
    sculpt::PenPoint last_;
};

} // namespace vs::desktop
