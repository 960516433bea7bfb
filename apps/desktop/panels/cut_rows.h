// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QFormLayout;

namespace vs::desktop {

class CutTool;
class StudioController;

// The rows that all tools have that cut: what they act on (those that can choose), cut or restore, and the
// radius. Object names begin with `prefix`.
void addCutOrRestore(QFormLayout* form, CutTool& tool, StudioController& studio, const QString& prefix);
void addRadius(QFormLayout* form, CutTool& tool, const QString& prefix);

} // namespace vs::desktop
