// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace vs::desktop {

class CameraTool;
class ClipTool;
class DrillTool;
class IslandTool;
class KeepTool;
class LaserTool;
class MeasureTool;
class MoveTool;
class PaintTool;
class PeelTool;
class ScissorsTool;
class SeedTool;
class SlicePen;
class StudioController;
class SweepTool;

// Makes all tools and has them: the studio owns it, and knows the one in hand as a Tool and no more. At first
// the camera is in hand.
class ToolBox : public QObject {
    Q_OBJECT

public:
    explicit ToolBox(StudioController& studio);

    [[nodiscard]] CameraTool& camera() const { return camera_; }
    [[nodiscard]] PeelTool& peel() const { return peel_; }
    [[nodiscard]] DrillTool& drill() const { return drill_; }
    [[nodiscard]] LaserTool& laser() const { return laser_; }
    [[nodiscard]] SweepTool& sweep() const { return sweep_; }
    [[nodiscard]] ScissorsTool& scissors() const { return scissors_; }
    [[nodiscard]] KeepTool& keep() const { return keep_; }
    [[nodiscard]] ClipTool& clip() const { return clip_; }
    [[nodiscard]] SeedTool& seed() const { return seed_; }
    [[nodiscard]] MoveTool& move() const { return move_; }
    [[nodiscard]] IslandTool& island() const { return island_; }
    [[nodiscard]] PaintTool& paint() const { return paint_; }
    [[nodiscard]] MeasureTool& measure() const { return measure_; }
    // What seed, paint and measure tool do with a pen on a slice.
    [[nodiscard]] SlicePen& slicePen() const { return slicePen_; }

private:
    CameraTool& camera_;
    PeelTool& peel_;
    DrillTool& drill_;
    LaserTool& laser_;
    SweepTool& sweep_;
    ScissorsTool& scissors_;
    KeepTool& keep_;
    ClipTool& clip_;
    SeedTool& seed_;
    MoveTool& move_;
    IslandTool& island_;
    PaintTool& paint_;
    MeasureTool& measure_;
    SlicePen& slicePen_;
};

} // namespace vs::desktop
