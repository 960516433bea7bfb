// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/sketch_tool.h"

#include "studio/operations/operation.h"

#include <functional>

namespace vs::studio {
class Document;
}

namespace vs::desktop {

// First a mask is sketched, which then stays in hand; pressing begins a stroke with it that is seen while the
// pen leads it. Letting go keeps the stroke, Escape takes it back. How it cuts is up to the tools made from
// this.
class MaskTool : public SketchTool<CutTool> {
    Q_OBJECT

public:
    explicit MaskTool(StudioController& studio);

    [[nodiscard]] QString hint() const override;
    [[nodiscard]] bool canActOnSegment() const override { return true; }
    [[nodiscard]] bool canActOnMaterial() const override { return true; }
    [[nodiscard]] Overlays overlays() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;
    void viewResized() override;
    [[nodiscard]] bool isBusy() const override { return isSketching() || isCutting_; }

protected:
    enum class State { Empty, Sketching, Ready, Cutting };

    struct Words {
        QString draw;   // the shape
        QString follow; // what to do with the mask
        QString cut;    // while it cuts
    };
    [[nodiscard]] virtual Words words() const = 0;
    // The mask where it is now.
    [[nodiscard]] virtual QPainterPath mask() const { return pad().area(); }
    // Whether a press there cuts with the mask that is ready, and does not begin a new one.
    [[nodiscard]] virtual bool isForMask(const Pen&) const { return true; }
    // What a press with the mask begins, without what the pen adds to it.
    [[nodiscard]] virtual studio::Operation stroke(const studio::Sketch& mask,
                                                   const studio::Canvas& canvas) const = 0;
    // The stroke has begun; the pen has moved on in it.
    virtual void begin(const Pen& pen) = 0;
    virtual void lead(const Pen& pen) = 0;
    // The pen is lifted: the document is given what it has not seen yet. Whether the stroke has come to
    // anything.
    virtual bool finish(const Pen& pen) = 0;

    [[nodiscard]] State state() const;
    // Shows more of the stroke. False: that failed, and the stroke is taken back.
    bool update(const std::function<void(studio::Document&)>& work);

private:
    [[nodiscard]] QString doing() const; // the hint, without what it works on
    void beginStroke(const Pen& pen);
    void endStroke(bool keep);

    bool isCutting_ = false;
};

} // namespace vs::desktop
