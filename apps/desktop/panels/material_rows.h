// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QFormLayout;

namespace vs::desktop {

class CutTool;
class StudioController;

// Which material a tool fills with, and what that is like; seen while the tool acts on material.
void addMaterial(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix);

} // namespace vs::desktop
