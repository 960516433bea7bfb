// SPDX-License-Identifier: Apache-2.0
#pragma once

class QPainter;

namespace vs::desktop {

struct Overlay;

// Paints a tool's overlay in logical pixels of the view.
void paintOverlay(QPainter& painter, const Overlay& overlay);

} // namespace vs::desktop
