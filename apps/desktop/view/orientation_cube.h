// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <QPointF>

#include <optional>

namespace vs::desktop {

class StudioController;

// The orientation marker over the view as something to take hold of, whatever the tool: a click on a face, an
// edge or a corner looks from there, a drag turns the volume. Places are logical pixels of the view.
class OrientationCube {
public:
    explicit OrientationCube(StudioController& studio) : studio_(studio) {}

    // The pen is at a place without a button; nothing: it has left. True: another zone is pointed at.
    bool point(const std::optional<QPointF>& place);
    // What is pointed at (render::zoneAt()): it is lit.
    [[nodiscard]] const std::optional<glm::dvec3>& pointedAt() const { return pointedAt_; }
    // Where a zone that faces the viewer is seen, for scripts that click on it: the direction's place on the
    // cube.
    [[nodiscard]] QPointF placeOf(glm::dvec3 zone) const;

    // False: the cube is not there.
    bool press(QPointF place);
    void move(QPointF place);
    void release();

private:
    StudioController& studio_;
    std::optional<glm::dvec3> pointedAt_;
    QPointF pressed_;
    QPointF last_;
    bool isDragged_ = false;
};

} // namespace vs::desktop
