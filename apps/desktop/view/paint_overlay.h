// SPDX-License-Identifier: Apache-2.0
#pragma once

class QPainter;
class QRectF;

namespace vs::desktop {

struct Overlay;

// Paints a tool's overlay in logical pixels of the view, which is `area` large. Smooth on any paint device.
void paintOverlay(QPainter& painter, const Overlay& overlay, QRectF area);

} // namespace vs::desktop
