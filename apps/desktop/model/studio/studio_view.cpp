// SPDX-License-Identifier: Apache-2.0
#include "model/studio/studio_controller.h"

#include "model/studio/tool.h"

namespace vs::desktop {

void StudioController::setMode(render::Mode mode) {
    auto next = view_;
    next.mode = mode;
    look(next);
}

void StudioController::setTransferFunction(const std::optional<render::TransferFunction>& function) {
    auto next = view_;
    next.transferFunction = function;
    look(next);
}

void StudioController::setSculptureView(field::SculptureView sculptureView) {
    auto next = view_;
    next.sculptureView = sculptureView;
    look(next);
}

void StudioController::setShadows(bool shadows) {
    auto next = view_;
    next.shadows = shadows;
    look(next);
}

void StudioController::setRange(Range range) {
    auto next = view_;
    next.range = range;
    look(next);
}

void StudioController::setHidesAbove(bool hidesAbove) {
    auto next = view_;
    next.hidesAbove = hidesAbove;
    look(next);
}

void StudioController::setSurfaceSmoothing(double sigma) {
    auto next = view_;
    next.surfaceSmoothing = sigma;
    look(next);
}

void StudioController::setTintsSegments(bool tintsSegments) {
    auto next = view_;
    next.tintsSegments = tintsSegments;
    look(next);
}

Range StudioController::visibleRange() const { return view_.visibleRange(document_->volume().range); }

void StudioController::setSampling(field::Sampling sampling) {
    auto next = view_;
    next.sampling = sampling;
    look(next);
}

void StudioController::setViewport(QSizeF logical, glm::ivec2 device) {
    if (isAway()) { // with the viewport as it was
        newViewport_ = {logical, device};
        schedule(0);
        return;
    }
    newViewport_.reset(); // an older one
    const bool isNew = device != picture_->viewport();
    logical_ = logical;
    picture_->setViewport(device);
    if (isNew) {
        tool_->viewResized();
        wake();
    }
}

glm::dvec2 StudioController::devicePerLogical() const {
    return glm::dvec2(picture_->viewport()) / glm::dvec2(logical_.width(), logical_.height());
}

QPointF StudioController::viewCentre() const { return {0.5 * logical_.width(), 0.5 * logical_.height()}; }

render::ViewRays StudioController::rays() const {
    return render::viewRays(view_.camera, *geometry(), glm::max(picture_->viewport(), glm::ivec2(1)));
}

QPointF StudioController::seenAt(glm::dvec3 world) const {
    const glm::dvec2 logical = rays().project(world) / devicePerLogical();
    return {logical.x, logical.y};
}

double StudioController::millimetresPerPixel() {
    return document_ == nullptr ? 1 : rays().pixelMm(geometry()->centreWorld()) * devicePerLogical().y;
}

} // namespace vs::desktop
