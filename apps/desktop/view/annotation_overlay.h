// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/camera/camera.h"

#include <QImage>
#include <QPointF>

#include <optional>
#include <vector>

class QPainter;

namespace vs::desktop {

// Scale bar and orientation marker over the view: the same as on saved pictures, but legible on dense screens
// too, and never part of those that the view saves. Drawn again only when camera, volume or size changed.
class AnnotationOverlay {
public:
    struct Shown {
        render::Camera camera;
        volume::GridGeometry geometry;
        std::optional<glm::dvec3> pointedAt; // of the orientation marker (render::zoneAt())
        bool operator==(const Shown&) const = default;
    };
    // `device` is the view's size in device pixels; the painter's units are logical ones.
    void paint(QPainter& painter, const Shown& shown, glm::ivec2 device);

private:
    struct Key {
        Shown shown;
        glm::ivec2 device{0};
        double scale = 1;
        bool operator==(const Key&) const = default;
    };
    struct Part {
        QImage image;
        glm::ivec2 corner{0}; // device pixels
    };

    std::optional<Key> key_;
    std::vector<Part> parts_;
};

} // namespace vs::desktop
