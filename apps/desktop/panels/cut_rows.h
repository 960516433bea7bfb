// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QFormLayout;
class QSlider;
class QWidget;

namespace vs::desktop {

class CutTool;
class StudioController;
class StudioTool;

// The rows that all tools have that cut: what they act on (those that can choose), cut or restore, what they
// take of the segments, and the radius. Object names begin with `prefix`.
void addCutOrRestore(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix);
void addLimits(QFormLayout* form, StudioTool& tool, StudioController& studio, const QString& prefix);
void addRadius(QFormLayout* form, CutTool& tool, const QString& prefix);

// A slider over steps, `perStep` positions of it for each, with its value in steps and in millimetres of the
// open volume beside it.
QWidget* withSteps(QSlider* slider, int perStep, StudioController& studio);
// "3.5 steps, 3.3 mm".
QString stepsAndMm(double steps, StudioController& studio);

} // namespace vs::desktop
