// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace vs::desktop {

class StudioController;

// The tool panel's page for each tool: what can be set for it.
QWidget* makeCameraPage();
QWidget* makePeelPage(StudioController& studio);
QWidget* makeDrillPage(StudioController& studio);
QWidget* makeLaserPage(StudioController& studio);
QWidget* makeSweepPage(StudioController& studio);
QWidget* makeScissorsPage(StudioController& studio);
QWidget* makeKeepPage(StudioController& studio);
QWidget* makeClipPage(StudioController& studio);
QWidget* makeSeedPage(StudioController& studio);
QWidget* makeIslandPage(StudioController& studio);
QWidget* makeMeasurePage(StudioController& studio);
QWidget* makePaintPage(StudioController& studio);
QWidget* makeMovePage(StudioController& studio);

// What the pages of all tools that follow the pen share: its pressure.
QWidget* makePressureRows(StudioController& studio);

} // namespace vs::desktop
