// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace vs::desktop {

class StudioController;
class ToolBox;

// The tool panel's page for each tool: what can be set for it.
QWidget* makeCameraPage(StudioController& studio, ToolBox& tools);
QWidget* makePeelPage(StudioController& studio, ToolBox& tools);
QWidget* makeDrillPage(StudioController& studio, ToolBox& tools);
QWidget* makeLaserPage(StudioController& studio, ToolBox& tools);
QWidget* makeSweepPage(StudioController& studio, ToolBox& tools);
QWidget* makeScissorsPage(StudioController& studio, ToolBox& tools);
QWidget* makeKeepPage(StudioController& studio, ToolBox& tools);
QWidget* makeClipPage(StudioController& studio, ToolBox& tools);
QWidget* makeSeedPage(StudioController& studio, ToolBox& tools);
QWidget* makeIslandPage(StudioController& studio, ToolBox& tools);
QWidget* makeMarkPage(StudioController& studio, ToolBox& tools);
QWidget* makeMeasurePage(StudioController& studio, ToolBox& tools);
QWidget* makePaintPage(StudioController& studio, ToolBox& tools);
QWidget* makeMovePage(StudioController& studio, ToolBox& tools);

// What the pages of all tools that follow the pen share: its pressure.
QWidget* makePressureRows(StudioController& studio);

} // namespace vs::desktop
