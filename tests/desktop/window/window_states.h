// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio_window.h"

#include <functional>
#include <string>

namespace vs::desktop {

// Shows everything that the window can show, one thing after the other, at the size that a laptop has: the
// start screen, each tool's page with all cards unfolded, each page of the histogram, slices and history,
// each dialog. Calls `look` with the name of each and the widgets that are to be looked at.
void forEachState(StudioWindow& w,
                  const std::function<void(const std::string&, const QList<QWidget*>&)>& look);

// "QToolButton 'drillTool' (Drill)": for messages.
std::string described(const QWidget& widget);

} // namespace vs::desktop
