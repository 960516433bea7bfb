// SPDX-License-Identifier: Apache-2.0
#include "annotation_overlay.h"

#include "render/draw_annotations.h"

#include <QPainter>

namespace vs::desktop {

namespace {

QImage premultiplied(const image::Image& image) {
    const QImage straight(image.rgba.data(), image.width, image.height, 4 * image.width,
                          QImage::Format_RGBA8888);
    return straight.convertToFormat(QImage::Format_ARGB32_Premultiplied); // a copy of its own
}

} // namespace

void AnnotationOverlay::paint(QPainter& painter, const render::Camera& camera,
                              const volume::GridGeometry& geometry, glm::ivec2 device) {
    if (device.x < 1 || device.y < 1) {
        return;
    }
    const Key key{camera, geometry, device};
    if (key != key_) {
        key_ = key;
        parts_.clear();
        const render::ViewRays rays = render::viewRays(camera, geometry, device);
        for (const auto& drawn :
             {render::drawScaleBar(render::scaleBar(rays, geometry), device, render::Ink::Light),
              render::drawOrientationMarker(render::orientationMarker(rays), device, render::Ink::Light)}) {
            parts_.push_back({premultiplied(drawn.image), drawn.corner});
        }
    }
    const double scale = painter.device()->devicePixelRatioF();
    for (auto& part : parts_) {
        part.image.setDevicePixelRatio(scale);
        painter.drawImage(QPointF(part.corner.x / scale, part.corner.y / scale), part.image);
    }
}

} // namespace vs::desktop
