// SPDX-License-Identifier: Apache-2.0
#include "tools/tool_box.h"

#include "model/studio/studio_controller.h"
#include "tools/camera_tool.h"
#include "tools/clip_tool.h"
#include "tools/drill_tool.h"
#include "tools/island_tool.h"
#include "tools/keep_tool.h"
#include "tools/laser_tool.h"
#include "tools/mark_tool.h"
#include "tools/measure_tool.h"
#include "tools/move_tool.h"
#include "tools/paint_tool.h"
#include "tools/peel_tool.h"
#include "tools/play_tool.h"
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/slice_pen.h"
#include "tools/sweep_tool.h"

namespace vs::desktop {

// The studio owns the tools as it owns the box.
ToolBox::ToolBox(StudioController& studio) : QObject(&studio) {
    auto* camera = new CameraTool(studio);
    auto* seed = new SeedTool(studio);
    auto* paint = new PaintTool(studio, *camera);
    auto* measure = new MeasureTool(studio, *camera);
    tools_ = {camera,
              new PeelTool(studio),
              new DrillTool(studio),
              new LaserTool(studio),
              new SweepTool(studio),
              new ScissorsTool(studio),
              new KeepTool(studio),
              new ClipTool(studio, *camera),
              seed,
              new MoveTool(studio, *camera),
              new IslandTool(studio),
              paint,
              measure,
              new MarkTool(studio),
              new PlayTool(studio, *camera)};
    slicePen_ = new SlicePen(studio, *seed, *paint, *measure);
    for (Tool* tool : tools_) {
        studio.hand().listenTo(*tool);
    }
    studio.hand().take(*camera);
    connect(&studio.host(), &DocumentHost::closing, this, [&studio, camera] {
        studio.hand().take(*camera); // which drops what another has in hand
        camera->clear();
    });
}

} // namespace vs::desktop
