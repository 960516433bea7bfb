// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/hand/sketch_pad.h"
#include "tools/cut_tool.h"

namespace vs::desktop {

// First a mask is sketched; then dragging down inside it peels layers off, and dragging up puts them back.
// The mask stays after a peel, so a further drag goes on from the new surface; drawing outside it makes a new
// mask.
class PeelTool : public CutTool {
    Q_OBJECT

public:
    explicit PeelTool(StudioController& studio);

    [[nodiscard]] QString name() const override { return "peel"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool canActOnSegment() const override { return true; }
    [[nodiscard]] Overlays overlays() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    bool accept() override; // a polyline ends
    void clear() override;
    void viewResized() override;
    void advance() override;
    [[nodiscard]] bool isBusy() const override {
        return state_ == State::Sketching || state_ == State::Peeling;
    }
    [[nodiscard]] bool isSketching() const override { return state_ == State::Sketching; }

    // Layers taken off by the stroke in hand, or by the last one.
    [[nodiscard]] double layers() const { return wanted_; }

signals:
    void layersChanged();

private:
    [[nodiscard]] QString doing() const; // the hint, without what it works on
    enum class State { Empty, Sketching, Ready, Peeling };

    void setState(State state);
    void takeMask();
    void peelTo(const Pen& pen);
    void stop();

    SketchPad pad_;
    State state_ = State::Empty;
    bool isInside_ = false; // the pen hovers over the mask
    QPointF pressed_;
    double wanted_ = 0;  // layers, from the pen
    double applied_ = 0; // layers, in the document
};

} // namespace vs::desktop
