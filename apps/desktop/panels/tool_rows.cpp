// SPDX-License-Identifier: Apache-2.0
#include "panels/tool_rows.h"

#include "model/texts/texts.h"
#include "panels/tool_pages.h"
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
#include "tools/scissors_tool.h"
#include "tools/seed_tool.h"
#include "tools/sweep_tool.h"
#include "tools/tool_box.h"

namespace vs::desktop {

std::string ToolRow::actionName() const { return tool.name().toStdString() + "Tool"; }

std::string ToolRow::pictureName() const { return picture != nullptr ? picture : tool.name().toStdString(); }

std::vector<ToolRow> toolRows(ToolBox& tools) {
    using Group = ToolRow::Group;
    return {
        {tools.get<CameraTool>(), Group::Views, 1, "V", tr("Camera"), tr("Turn the volume"), tr("Camera"),
         makeCameraPage},
        {tools.get<PeelTool>(), Group::Cuts, 3, "P", tr("Peel"), tr("Peel layers off the surface"),
         tr("Peel"), makePeelPage},
        {tools.get<DrillTool>(), Group::Cuts, 4, "D", tr("Drill"), tr("Drill along the view"), tr("Drill"),
         makeDrillPage},
        {tools.get<LaserTool>(), Group::Cuts, 5, "B", tr("Laser"),
         tr("Burn down from the surface along its normal"), tr("Laser"), makeLaserPage},
        {tools.get<SweepTool>(), Group::Cuts, 6, "W", tr("Sweep"), tr("Sweep a shape along a way"),
         tr("Sweep"), makeSweepPage},
        {tools.get<ScissorsTool>(), Group::Cuts, 7, "X", tr("Scissors"),
         tr("Cut through everything inside a stroke, or outside it"), tr("Scissors"), makeScissorsPage},
        {tools.get<KeepTool>(), Group::Cuts, 9, "K", tr("Keep"),
         tr("Keep what is connected to the place clicked, cut all else"), tr("Keep connected"), makeKeepPage},
        {tools.get<ClipTool>(), Group::Cuts, 8, "C", tr("Clip"), tr("Clip by a box and a plane"), tr("Clip"),
         makeClipPage},
        {tools.get<SeedTool>(), Group::Marks, 2, "S", tr("Seed"), tr("Mark what should be segmented"),
         tr("Seed"), makeSeedPage},
        {tools.get<IslandTool>(), Group::Marks, 10, "H", tr("Island"),
         tr("Drop the part of the segment that is clicked, or keep only it"), tr("Island"), makeIslandPage},
        {tools.get<PaintTool>(), Group::Marks, 11, "T", tr("Paint"),
         tr("Correct the segment with a brush, on the slices"), tr("Paint"), makePaintPage},
        {tools.get<MoveTool>(), Group::Marks, 0, "G", tr("Move"),
         tr("Move, turn and scale pasted parts and segments that are pulled out"), tr("Move part"),
         makeMovePage},
        {tools.get<MarkTool>(), Group::Marks, 13, "J", tr("Mark"),
         tr("Draw with a marking pen on the surface; the marks stay on the material"), tr("Mark"),
         makeMarkPage},
        {tools.get<MeasureTool>(), Group::Marks, 12, "M", tr("Measure"),
         tr("Measure distances and angles, on the surface and on slices"), tr("Measure"), makeMeasurePage},
    };
}

} // namespace vs::desktop
