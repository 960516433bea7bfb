// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/mask_tool.h"

namespace vs::desktop {

// Dragging down inside the mask peels layers off, and dragging up puts them back. The mask stays after a
// peel, so a further drag goes on from the new surface; drawing outside it makes a new mask.
class PeelTool : public MaskTool {
    Q_OBJECT

public:
    explicit PeelTool(StudioController& studio) : MaskTool(studio) {}

    [[nodiscard]] QString name() const override { return "peel"; }
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void release(const Pen& pen) override;
    void hover(const Pen& pen) override;
    void clear() override;
    void advance() override;

    // Layers taken off by the stroke in hand, or by the last one.
    [[nodiscard]] double layers() const { return wanted_; }

signals:
    void layersChanged();

protected:
    [[nodiscard]] Words words() const override;
    [[nodiscard]] bool isForMask(const Pen& pen) const override;
    [[nodiscard]] studio::Operation stroke(const studio::Sketch& mask,
                                           const studio::Canvas& canvas) const override;
    void begin(const Pen& pen) override;
    void lead(const Pen& pen) override;
    bool finish(const Pen& pen) override;
    void takeSketch() override;

private:
    bool isInside_ = false; // the pen hovers over the mask
    QPointF pressed_;
    double wanted_ = 0;  // layers, from the pen
    double applied_ = 0; // layers, in the document
};

} // namespace vs::desktop
