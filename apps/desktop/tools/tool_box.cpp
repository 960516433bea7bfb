// SPDX-License-Identifier: Apache-2.0
#include "tools/tool_box.h"

#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/clip_tool.h"
#include "tools/drill_tool.h"
#include "tools/island_tool.h"
#include "tools/keep_tool.h"
#include "tools/laser_tool.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/paint_tool.h"
#include "tools/peel_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/slice_pen.h"
#include "tools/sweep_tool.h"

namespace vs::desktop {

// The studio owns the tools as it owns the box.
ToolBox::ToolBox(StudioController& studio)
    : QObject(&studio), camera_(*new CameraTool(studio)), peel_(*new PeelTool(studio)),
      drill_(*new DrillTool(studio)), laser_(*new LaserTool(studio)), sweep_(*new SweepTool(studio)),
      scissors_(*new ScissorsTool(studio)), keep_(*new KeepTool(studio)),
      clip_(*new ClipTool(studio, camera_)), seed_(*new SeedTool(studio)),
      move_(*new MoveTool(studio, camera_)), island_(*new IslandTool(studio)),
      paint_(*new PaintTool(studio, camera_)), measure_(*new MeasureTool(studio, camera_)),
      slicePen_(*new SlicePen(studio, seed_, paint_, measure_)) {
    for (Tool* tool :
         std::initializer_list<Tool*>{&camera_, &peel_, &drill_, &laser_, &sweep_, &scissors_, &keep_, &clip_,
                                      &seed_, &move_, &island_, &paint_, &measure_}) {
        studio.hand().listenTo(*tool);
    }
    studio.hand().take(camera_);
    connect(&studio.host(), &DocumentHost::closing, this, [this, &studio] {
        studio.hand().take(camera_); // which drops what another has in hand
        camera_.clear();
    });
}

} // namespace vs::desktop
