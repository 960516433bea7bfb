// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace vs::desktop {

// Our own line icons by name ("open", "peel" ...), drawn at any size; quiet when disabled.
QIcon icon(const char* name);

} // namespace vs::desktop
