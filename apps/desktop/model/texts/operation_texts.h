// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/operation.h"

#include <QString>

namespace vs::desktop {

// An operation as the history shows it: "Peel, 3.5 layers", "Segment “Liver”".
QString describe(const studio::Operation& operation);

// The name of its icon.
const char* iconName(const studio::Operation& operation);

} // namespace vs::desktop
