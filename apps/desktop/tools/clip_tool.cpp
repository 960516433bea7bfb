// SPDX-License-Identifier: Apache-2.0
#include "tools/clip_tool.h"

#include "model/hand/world_lines.h"
#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/live_stroke.h"
#include "tools/camera_tool.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

namespace vs::desktop {

ClipTool::ClipTool(StudioController& studio, CameraTool& camera) : CutTool(studio), camera_(camera) {
    constexpr int kCalmMs = 400;
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, &ClipTool::finish);
    connect(&studio.host(), &DocumentHost::changed, this, &ClipTool::takeStanding);
    connect(this, &CutTool::settingsChanged, this,
            &ClipTool::finishPending); // a stroke stays what it began as
}

QString ClipTool::hint() const {
    if (cutsInside()) {
        return restores() ? tr("Move the faces of the box, or the plane, in the panel on the left: what lies "
                               "inside is put back. Drag to turn.")
                          : tr("Move the faces of the box, or the plane, in the panel on the left: what lies "
                               "inside is cut. Drag to turn.");
    }
    return restores()
               ? tr("Move the faces of the box, or the plane, in the panel on the left: what lies outside is "
                    "put back. Drag to turn.")
               : tr("Move the faces of the box, or the plane, in the panel on the left: what lies outside is "
                    "cut. Drag to turn.");
}

Overlays ClipTool::overlays() const {
    const auto* geometry = studio_.host().geometry();
    if (geometry == nullptr) {
        return {};
    }
    const auto frame = box();
    const auto tint = isOpen_ ? cuttingTint() : idleTint();
    return {{boxEdges(frame.lo, frame.hi, geometry->worldFromVoxel, studio_.view()), tint, 0, 1.2}};
}

Qt::CursorShape ClipTool::cursor() const { return camera_.cursor(); }

void ClipTool::press(const Pen& pen) {
    finishPending(); // the view stands still while a clip is shown
    camera_.press(pen);
}
void ClipTool::move(const Pen& pen) { camera_.move(pen); }
void ClipTool::release(const Pen& pen) { camera_.release(pen); }

// --- what is set

studio::Clip::Box ClipTool::wholeBox() const {
    const auto* geometry = studio_.host().geometry();
    const glm::dvec3 dims = geometry != nullptr ? glm::dvec3(geometry->dims) : glm::dvec3(1);
    return {glm::dvec3(-0.5), dims - 0.5};
}

studio::Clip::Box ClipTool::box() const {
    const auto whole = wholeBox();
    return clip_.box ? studio::Clip::Box{glm::clamp(clip_.box->lo, whole.lo, whole.hi),
                                         glm::clamp(clip_.box->hi, whole.lo, whole.hi)}
                     : whole;
}

double ClipTool::greatestOffset() const {
    const auto* geometry = studio_.host().geometry();
    return geometry != nullptr ? 0.5 * geometry->diagonalMm() : 1;
}

double ClipTool::planeOffset() const {
    const auto* geometry = studio_.host().geometry();
    if (!hasPlane() || geometry == nullptr) {
        return 0;
    }
    const auto& plane = clip_.planes.front();
    return glm::dot(plane.point - geometry->centreWorld(), glm::normalize(plane.normal));
}

QString ClipTool::directionOf(const volume::GridGeometry& geometry, int axis, bool isHi) {
    const std::map<char, std::pair<QString, char>> names{
        {'L', {tr("Left"), 'R'}},     {'R', {tr("Right"), 'L'}},    {'P', {tr("Posterior"), 'A'}},
        {'A', {tr("Anterior"), 'P'}}, {'S', {tr("Superior"), 'I'}}, {'I', {tr("Inferior"), 'S'}}};
    const auto& towards = names.at(geometry.orientationCode().at(std::size_t(axis)));
    return isHi ? towards.first : names.at(towards.second).first;
}

void ClipTool::setBox(const studio::Clip::Box& box, bool isDragged) {
    auto next = clip_;
    next.box = box;
    show(next, isDragged);
}

void ClipTool::setPlaneOffset(double mm, bool isDragged) {
    if (hasPlane() && studio_.host().geometry() != nullptr) {
        auto next = clip_;
        auto& plane = next.planes.front();
        plane.point = studio_.host().geometry()->centreWorld() + mm * glm::normalize(plane.normal);
        show(next, isDragged);
    }
}

void ClipTool::setCutsInside(bool inside) {
    auto next = clip_;
    next.cutsInside = inside;
    show(next, false);
}

void ClipTool::facePlane() {
    if (studio_.host().geometry() != nullptr) {
        const double offset = planeOffset();
        const glm::dvec3 towards = -studio_.view().rays().forward;
        auto next = clip_;
        next.planes = {{studio_.host().geometry()->centreWorld() + offset * towards, towards}};
        show(next, false);
    }
}

void ClipTool::dropPlane() {
    auto next = clip_;
    next.planes.clear();
    show(next, false);
}

void ClipTool::reset() { show({}, false); }

// Faces that were not moved cut nothing, not even the soft edge of a cut. Without any other, nothing is said
// of a box.
studio::Clip ClipTool::operation() const {
    constexpr double kFarOutside = 16; // voxels
    studio::Clip clip = clip_;
    const auto whole = wholeBox();
    auto set = box();
    bool isMoved = false;
    for (int axis = 0; axis < 3; ++axis) {
        const bool isLo = set.lo[axis] > whole.lo[axis];
        const bool isHi = set.hi[axis] < whole.hi[axis];
        set.lo[axis] -= isLo ? 0 : kFarOutside;
        set.hi[axis] += isHi ? 0 : kFarOutside;
        isMoved = isMoved || isLo || isHi;
    }
    clip.box.reset();
    if (isMoved) {
        clip.box = set;
    }
    return clip;
}

// --- showing it

void ClipTool::show(const studio::Clip& clip, bool isDragged) {
    if (!isOpen_ && !open()) {
        emit clipChanged();
        return;
    }
    clip_ = clip;
    clip_.restores = begun_.restores;
    clip_.radius = begun_.radius;
    isStale_ = true;
    studio_.host().wake();
    if (isDragged) {
        calm_.stop();
    } else {
        calm_.start();
    }
    emit clipChanged();
    emit overlayChanged();
}

// Takes back the clip that stands, and begins a stroke that shows the one to come.
bool ClipTool::open() {
    auto* document = studio_.host().document();
    if (document == nullptr || studio_.host().isLoading()) {
        return false;
    }
    replaces_ = standing() != nullptr;
    isReplacing_ = true; // it is not somebody else who takes it back
    const bool isBack = !replaces_ || studio_.editor().apply(studio::Undo{});
    isReplacing_ = false;
    begun_ = {};
    begun_.radius = radius();
    begun_.restores = restores();
    isOpen_ =
        isBack && studio_.editor().beginStroke([&](auto& open, const auto&) { open.stroke().begin(begun_); });
    return isOpen_;
}

void ClipTool::advance() {
    if (isOpen_ && isStale_) {
        isStale_ = false;
        studio::Clip clip = operation();
        if (!studio_.host().workLong([&] { studio_.host().document()->stroke().clipTo(clip); })) {
            drop();
        }
    }
}

void ClipTool::finish() {
    calm_.stop();
    advance();
    if (!isOpen_) {
        return;
    }
    isOpen_ = false;
    const studio::Clip clip = operation();
    const bool clipsNothing = !clip.box && clip.planes.empty();
    const bool isDone = studio_.editor().endStroke(!clipsNothing);
    if (clipsNothing) {
        studio_.host().say(tr("Nothing is clipped"));
    } else if (!isDone && replaces_) { // given up: the one before stays
        studio_.editor().apply(studio::Redo{});
    }
    emit overlayChanged();
}

void ClipTool::finishPending() {
    if (isOpen_) {
        finish();
    }
}

// As it was before the stroke.
void ClipTool::drop() {
    calm_.stop();
    isStale_ = false;
    isOpen_ = false;
    studio_.editor().endStroke(false);
    if (replaces_) {
        studio_.editor().apply(studio::Redo{});
    }
    emit overlayChanged();
}

void ClipTool::clear() {
    if (isOpen_) {
        calm_.isActive() ? finish() : drop(); // what is not held any more was meant
    }
}

// The last thing done, if it was a clip that cuts, or restores, as the next one will.
const studio::Clip* ClipTool::standing() const {
    const auto* last = studio_.host().facts()->lastEdit();
    const auto* clip = last != nullptr ? std::get_if<studio::Clip>(last) : nullptr;
    return clip != nullptr && clip->restores == restores() ? clip : nullptr;
}

// The panel shows the clip that a further change would take the place of, or none.
void ClipTool::takeStanding() {
    auto* document = studio_.host().document();
    if (isOpen_ || isReplacing_ || document == nullptr || studio_.host().isLoading()) {
        return;
    }
    const auto* shown = standing();
    clip_ = shown != nullptr ? *shown : studio::Clip{};
    emit clipChanged();
}

} // namespace vs::desktop
