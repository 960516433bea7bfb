// SPDX-License-Identifier: Apache-2.0
#include "model/document/view_model.h"

#include "model/document/document_host.h"
#include "studio/document/document_facts.h"

namespace vs::desktop {

ViewModel::ViewModel(DocumentHost& host) : host_(host) {}

void ViewModel::showView(const studio::View& view) {
    if (host_.geometry() == nullptr || view == view_) {
        return;
    }
    view_ = view;
    isPending_ = true;
    host_.wake();
}

void ViewModel::setMode(render::Mode mode) {
    auto next = view_;
    next.mode = mode;
    showView(next);
}

void ViewModel::setTransferFunction(const std::optional<render::TransferFunction>& function) {
    auto next = view_;
    next.transferFunction = function;
    showView(next);
}

namespace {

void apply(const render::SuitedView& wanted, studio::View& view) {
    view.mode = wanted.mode.value_or(view.mode);
    view.shadows = wanted.shadows.value_or(view.shadows);
    view.sampling = wanted.sampling.value_or(view.sampling);
}

} // namespace

void ViewModel::chooseTransferFunction(const std::optional<render::TransferFunction>& function) {
    auto next = view_;
    next.transferFunction = function;
    if (function) {
        apply(function->suits, next);
    }
    showView(next);
}

void ViewModel::suit(const render::SuitedView& wanted) {
    auto next = view_;
    apply(wanted, next);
    showView(next);
}

void ViewModel::setSculptureView(field::SculptureView sculptureView) {
    auto next = view_;
    next.sculptureView = sculptureView;
    showView(next);
}

void ViewModel::setShadows(bool shadows) {
    auto next = view_;
    next.shadows = shadows;
    showView(next);
}

void ViewModel::setRange(Range range) {
    auto next = view_;
    next.range = range;
    showView(next);
}

void ViewModel::setHidesAbove(bool hidesAbove) {
    auto next = view_;
    next.hidesAbove = hidesAbove;
    showView(next);
}

void ViewModel::setSurfaceSmoothing(double sigma) {
    auto next = view_;
    next.surfaceSmoothing = sigma;
    showView(next);
}

void ViewModel::setTintsSegments(bool tintsSegments) {
    auto next = view_;
    next.tintsSegments = tintsSegments;
    showView(next);
}

void ViewModel::setInverted(bool isInverted) {
    auto next = view_;
    next.isInverted = isInverted;
    showView(next);
}

void ViewModel::setSampling(field::Sampling sampling) {
    auto next = view_;
    next.sampling = sampling;
    showView(next);
}

void ViewModel::setSmoothsSegments(bool smooths) {
    auto next = view_;
    next.smoothsSegments = smooths;
    showView(next);
}

void ViewModel::setSpread(double spread) {
    auto next = view_;
    next.spread = spread;
    showView(next);
}

void ViewModel::setSliceWindow(std::optional<Range> window) {
    auto next = view_;
    next.sliceWindow = window;
    showView(next);
}

Range ViewModel::sliceWindow() const { return view_.sliceWindow.value_or(host_.facts()->sliceWindow); }

void ViewModel::setTintsSlices(bool tintsSlices) {
    auto next = view_;
    next.tintsSlices = tintsSlices;
    showView(next);
}

Range ViewModel::visibleRange() const { return view_.visibleRange(host_.volume()->range); }

void ViewModel::flush() {
    if (isPending_ && host_.document() != nullptr && !host_.facts()->isStrokeOpen()) {
        isPending_ = false;
        host_.guard([this] { host_.document()->showView(view_); });
        host_.tellSoon();
    }
}

void ViewModel::adopt() { view_ = host_.document()->view(); }

void ViewModel::forget() {
    view_ = {};
    isPending_ = false;
}

studio::Canvas ViewModel::canvas() {
    host_.gl().makeCurrent();
    flush();
    return {view_, viewport_};
}

void ViewModel::setViewport(QSizeF logical, glm::ivec2 device) {
    if (host_.isAway()) { // with the viewport as it was
        waiting_ = {logical, device};
        host_.workSoon();
        return;
    }
    waiting_.reset(); // an older one
    logical_ = logical;
    if (device != viewport_) {
        viewport_ = device;
        emit resized();
        host_.wake();
    }
}

void ViewModel::takeWaitingViewport() {
    if (const auto viewport = std::exchange(waiting_, {})) {
        setViewport(viewport->first, viewport->second);
    }
}

glm::dvec2 ViewModel::devicePerLogical() const {
    return glm::dvec2(viewport_) / glm::dvec2(logical_.width(), logical_.height());
}

QPointF ViewModel::centre() const { return {0.5 * logical_.width(), 0.5 * logical_.height()}; }

render::ViewRays ViewModel::rays() const {
    return render::viewRays(view_.camera, *host_.geometry(), glm::max(viewport_, glm::ivec2(1)));
}

QPointF ViewModel::seenAt(glm::dvec3 world) const {
    const glm::dvec2 logical = rays().project(world) / devicePerLogical();
    return {logical.x, logical.y};
}

double ViewModel::millimetresPerPixel() const {
    return host_.geometry() == nullptr
               ? 1
               : rays().pixelMm(host_.geometry()->centreWorld()) * devicePerLogical().y;
}

} // namespace vs::desktop
