// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/kinds/studio_tool.h"

#include "studio/operations/operation.h"

namespace vs::desktop {

class CameraTool;

// A round brush of a radius in mm, which adds to the segment at work or removes from it where it goes on a
// slice (SlicePen). In the 3D view it turns the volume.
class PaintTool : public StudioTool {
    Q_OBJECT

public:
    static constexpr double kLeastMm = 0.1;
    static constexpr double kMostMm = 50;

    PaintTool(StudioController& studio, CameraTool& camera);

    [[nodiscard]] QString name() const override { return "paint"; }
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] Qt::CursorShape cursor() const override;
    void press(const Pen& pen) override;
    void move(const Pen& pen) override;
    void release(const Pen& pen) override;
    void clear() override;

    [[nodiscard]] double radiusMm() const { return radiusMm_; }
    void setRadiusMm(double mm);
    // Wider or narrower by a factor.
    void resize(double factor) { setRadiusMm(radiusMm_ * factor); }
    [[nodiscard]] bool isToAdd() const { return isToAdd_; }
    void setToAdd(bool isToAdd);
    // A ball, which reaches into the neighbouring slices, or a disc on the one drawn on.
    [[nodiscard]] bool isBall() const { return isBall_; }
    void setBall(bool isBall);
    // Whether only voxels in the growth's range of intensities are painted; in the displayed one when nothing
    // has grown yet.
    [[nodiscard]] bool isInRangeOnly() const { return isInRangeOnly_; }
    void setInRangeOnly(bool isInRangeOnly);

    // Paints where the brush has gone on a slice: one edit of the document.
    void paint(studio::Trail trail, bool isReversed);

private:
    CameraTool& camera_;
    double radiusMm_ = 4;
    bool isToAdd_ = true;
    bool isBall_ = false;
    bool isInRangeOnly_ = false;
};

} // namespace vs::desktop
