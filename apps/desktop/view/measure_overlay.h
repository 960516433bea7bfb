// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QRectF>

#include <glm/glm.hpp>

#include <functional>
#include <optional>

class QPainter;

namespace vs::desktop {

class MeasureTool;

// Paints all measurements and the one in hand: lines from place to place, and what they measure beside them.
// `seenAt` says where a place of the world appears in a view that is `area` large; a measurement of which
// some place does not is left out.
void paintMeasurements(QPainter& painter, const MeasureTool& tool,
                       const std::function<std::optional<QPointF>(glm::dvec3)>& seenAt, QRectF area);

} // namespace vs::desktop
