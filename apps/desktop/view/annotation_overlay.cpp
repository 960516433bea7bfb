// SPDX-License-Identifier: Apache-2.0
#include "view/annotation_overlay.h"

#include "render/marks/draw_annotations.h"

#include <QPainter>

namespace vs::desktop {

namespace {

QImage premultiplied(const image::Image& image) {
    const QImage straight(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                          QImage::Format_RGBA8888);
    return straight.convertToFormat(QImage::Format_ARGB32_Premultiplied); // a copy of its own
}

} // namespace

void AnnotationOverlay::paint(QPainter& painter, const Shown& shown, glm::ivec2 device) {
    if (device.x < 1 || device.y < 1) {
        return;
    }
    const double scale = painter.device()->devicePixelRatioF();
    const Key key{shown, device, scale};
    if (key != key_) {
        key_ = key;
        parts_.clear();
        const render::ViewRays rays = render::viewRays(shown.camera, shown.geometry, device);
        for (const auto& drawn :
             {render::drawScaleBar(render::scaleBar(rays, shown.geometry, scale), device, render::Ink::Light,
                                   scale),
              render::drawOrientationMarker(render::orientationMarker(rays, scale, shown.pointedAt), device,
                                            render::Ink::Light, scale)}) {
            parts_.push_back({premultiplied(drawn.image), drawn.corner});
        }
    }
    for (auto& part : parts_) {
        part.image.setDevicePixelRatio(scale);
        painter.drawImage(QPointF(part.corner.x / scale, part.corner.y / scale), part.image);
    }
}

} // namespace vs::desktop
