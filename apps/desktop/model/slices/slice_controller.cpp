// SPDX-License-Identifier: Apache-2.0
#include "model/slices/slice_controller.h"

#include "model/document/document_host.h"
#include "model/document/view_model.h"
#include "studio/document/document_facts.h"
#include "studio/document/surface_queries.h"

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kLeastZoom = 0.25;
constexpr double kMostZoom = 64;
constexpr double kSegmentsMs = 10; // a slice, to smooth what grew
constexpr double kBricksMs = 20;   // and to wait for finer levels
} // namespace

SliceController::SliceController(DocumentHost& host, ViewModel& view) : host_(host), view_(view) {
    connect(&host_, &DocumentHost::opened, this, &SliceController::reset);
    connect(&host_, &DocumentHost::changed, this, &SliceController::touch);
}

bool SliceController::hasVolume() const { return host_.geometry() != nullptr; }

const std::vector<int>& SliceController::interpolated() const {
    static const std::vector<int> none;
    const volume::Volume* volume = host_.volume();
    return volume != nullptr ? volume->details.interpolated : none;
}

void SliceController::reset() {
    if (host_.geometry() == nullptr) {
        return;
    }
    crosshair_ = host_.geometry()->dims / 2;
    for (Pane& pane : panes_) {
        pane.zoom = 1;
        pane.centreMm = {};
        pane.drawn.reset();
    }
    touch();
}

// Something is stale perhaps: drawn when nothing else waits.
void SliceController::touch() {
    if (isAnyShown()) {
        host_.workSoon();
    }
    emit changed();
}

void SliceController::setShown(Kind kind, bool isShown) {
    if (pane(kind).isShown != isShown) {
        pane(kind).isShown = isShown;
        touch();
    }
}

bool SliceController::isAnyShown() const {
    return std::any_of(panes_.begin(), panes_.end(), [](const Pane& pane) { return pane.isShown; });
}

void SliceController::setSmooth(bool isSmooth) {
    isSmooth_ = isSmooth;
    touch();
}

void SliceController::setCrosshair(glm::dvec3 voxel) {
    const glm::ivec3 last = host_.geometry()->dims - 1;
    const glm::ivec3 next(glm::clamp(glm::floor(voxel + 0.5), glm::dvec3(0), glm::dvec3(last)));
    if (next != crosshair_) {
        crosshair_ = next;
        touch();
        emit crosshairMoved();
    }
}

void SliceController::scroll(Kind kind, int slices) {
    const render::SliceGeometry slice = geometry(kind);
    glm::dvec3 next(crosshair_);
    next[slice.axis()] += slices * slice.onwards();
    setCrosshair(next);
}

bool SliceController::centreOnSurface(QPointF place) {
    if (host_.document() == nullptr || host_.isLoading() || host_.facts()->isStrokeOpen()) {
        return false;
    }
    std::optional<studio::Probe> found;
    const glm::dvec2 pixel = glm::dvec2(place.x(), place.y()) * view_.devicePerLogical();
    const auto viewport = view_.canvas().viewport;
    host_.workLong([&] { found = host_.document()->surface().probe(pixel, viewport); });
    if (found) {
        setCrosshair(found->voxel);
    }
    return found.has_value();
}

glm::dvec3 SliceController::voxelAt(glm::dvec3 world) const {
    return glm::dvec3(host_.geometry()->voxelFromWorld() * glm::dvec4(world, 1.0));
}

render::SliceGeometry SliceController::geometry(Kind kind) const {
    return render::SliceGeometry(*host_.geometry(), kind);
}

render::SliceView SliceController::view(Kind kind) const {
    const Pane& shown = pane(kind);
    const render::SliceGeometry slice = geometry(kind);
    const glm::ivec2 size = glm::max(shown.pixels, glm::ivec2(1));
    return {kind, crosshair_[slice.axis()], shown.centreMm,
            render::pixelMmToShowAll(slice, size) / shown.zoom, size};
}

void SliceController::setViewport(Kind kind, glm::ivec2 pixels, double perLogical) {
    pane(kind).pixels = pixels;
    pane(kind).perLogical = perLogical;
    touch();
}

void SliceController::zoom(Kind kind, double factor, glm::dvec2 anchor) {
    Pane& shown = pane(kind);
    const double before = shown.zoom;
    shown.zoom = std::clamp(before * factor, kLeastZoom, kMostZoom);
    shown.centreMm = anchor + (shown.centreMm - anchor) * (before / shown.zoom);
    touch();
}

void SliceController::pan(Kind kind, glm::dvec2 mm) {
    pane(kind).centreMm += mm;
    touch();
}

void SliceController::showAll(Kind kind) {
    pane(kind).zoom = 1;
    pane(kind).centreMm = {};
    touch();
}

Range SliceController::window() const { return view_.sliceWindow(); }

void SliceController::leadWindow(const Range& from, glm::dvec2 moved) {
    constexpr double kPixels = 200; // to the right make the window e times as wide; up, half as bright again
    // Between what can just be told apart and what shows no difference any more.
    const double values = std::max(host_.volume()->range.width(), 1e-9);
    const double width = std::clamp(from.width() * std::exp(moved.x / kPixels), 1e-4 * values, 10 * values);
    const double level = 0.5 * (from.lo + from.hi) + 0.5 * width * moved.y / kPixels;
    // Numbers that can be read and written again: to a hundredth of the window.
    const double digit = std::pow(10, std::floor(std::log10(width)) - 2);
    const auto rounded = [&](double value) { return digit * std::round(value / digit); };
    view_.setSliceWindow(Range{rounded(level - 0.5 * width), rounded(level + 0.5 * width)});
}

std::optional<studio::Probe> SliceController::probe(Kind kind, glm::dvec2 place) {
    const auto* document = host_.document();
    if (document == nullptr) {
        return std::nullopt;
    }
    const render::SliceGeometry slice = geometry(kind);
    const glm::dvec3 voxel = slice.voxelAt(place, crosshair_[slice.axis()]);
    const glm::ivec3 nearest(glm::floor(voxel + 0.5));
    const auto& grid = document->volume().geometry;
    if (glm::any(glm::lessThan(nearest, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(nearest, grid.dims))) {
        return std::nullopt;
    }
    return studio::Probe{voxel, glm::dvec3(grid.worldFromVoxel * glm::dvec4(voxel, 1.0)),
                         document->volume().at(nearest)};
}

SliceController::Key SliceController::wanted(Kind kind) const {
    return {view(kind), host_.facts()->version, isSmooth_};
}

bool SliceController::isStale(Kind kind) const {
    const Pane& shown = pane(kind);
    return shown.isShown && shown.pixels.x > 0 && shown.pixels.y > 0 && shown.drawn != wanted(kind);
}

bool SliceController::step() {
    if (host_.geometry() == nullptr || host_.isLoading()) {
        return false;
    }
    std::optional<Kind> next;
    int stale = 0;
    for (const Kind kind : render::kSliceKinds) {
        if (isStale(kind)) {
            ++stale;
            next = !next || pane(kind).turn < pane(*next).turn ? kind : *next;
        }
    }
    if (next) {
        draw(*next);
    }
    return stale > 1 || (next && isStale(*next));
}

void SliceController::drawAnew() {
    for (Pane& pane : panes_) {
        pane.drawn.reset();
    }
    touch();
}

bool SliceController::isComplete() {
    return host_.geometry() == nullptr || std::none_of(render::kSliceKinds.begin(), render::kSliceKinds.end(),
                                                       [&](Kind kind) { return isStale(kind); });
}

void SliceController::draw(Kind kind) {
    Pane& shown = pane(kind);
    const Key key = wanted(kind);
    shown.turn = ++turns_;
    shown.drawn = key; // also when it fails: once is enough to be told
    bool isBehind = false;
    image::Image image;
    const bool isDrawn = host_.workLong([&] {
        if (!renderer_) {
            renderer_ = std::make_unique<render::SliceRenderer>();
        }
        render::SliceFrame frame = host_.document()->slice(key.view, kSegmentsMs);
        isBehind = host_.document()->isBehind();
        frame.isSmooth = key.isSmooth;
        frame.outlinePixels = float(1.25 * shown.perLogical);
        renderer_->render(frame, kBricksMs);
        isBehind = isBehind || renderer_->missesBricks();
        image = renderer_->readPicture();
    });
    if (isDrawn) { // opaque: the fastest to put on the screen
        shown.picture = QImage(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                               QImage::Format_RGBX8888)
                            .convertToFormat(QImage::Format_RGB32);
        shown.picture.setDevicePixelRatio(shown.perLogical);
    }
    if (isBehind) {
        shown.drawn.reset(); // and once more, with more of the segments, or of finer levels
    }
    emit pictureChanged(kind);
}

Overlays SliceController::overlays() const {
    if (!isAnyShown() || host_.geometry() == nullptr) {
        return {};
    }
    const glm::dvec4 world = host_.geometry()->worldFromVoxel * glm::dvec4(glm::dvec3(crosshair_), 1.0);
    const auto rays = view_.rays();
    if (!rays.isOrthographic && glm::dot(glm::dvec3(world) - rays.eye, rays.forward) < 1) {
        return {}; // behind the viewer
    }
    const QPointF at = view_.seenAt(glm::dvec3(world));
    QPainterPath mark;
    constexpr double kGap = 4;
    constexpr double kReach = 11;
    for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        mark.moveTo(at + kGap * way);
        mark.lineTo(at + kReach * way);
    }
    return {{mark, Overlay::Tint::Pen, 0, 1.5}};
}

} // namespace vs::desktop
