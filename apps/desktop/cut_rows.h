// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QFormLayout;

namespace vs::desktop {

class CutTool;

// The rows that all tools have that cut: cut or restore, and the radius. Object names begin with `prefix`.
void addCutOrRestore(QFormLayout* form, CutTool& tool, const QString& prefix);
void addRadius(QFormLayout* form, CutTool& tool, const QString& prefix);

} // namespace vs::desktop
