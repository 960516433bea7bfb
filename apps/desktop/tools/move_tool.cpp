// SPDX-License-Identifier: Apache-2.0
#include "tools/move_tool.h"

#include "model/hand/world_lines.h"
#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "tools/camera_tool.h"

#include <QFont>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vs::desktop {

namespace {
constexpr double kHandle = 12; // radius, logical pixels
constexpr double kReach = 18;  // of a click on it
constexpr double kMargin = 6;  // around the chosen part's box
constexpr double kDegreesPerPixel = 0.5;
constexpr double kPerNotch = 1.08;
} // namespace

MoveTool::MoveTool(StudioController& studio, CameraTool& camera)
    : StudioTool(studio), camera_(camera), parts_(studio) {
    constexpr int kCalmMs = 350;
    calm_.setSingleShot(true);
    calm_.setInterval(kCalmMs);
    connect(&calm_, &QTimer::timeout, this, &MoveTool::commit);
    connect(&studio.host(), &DocumentHost::changed, this, &MoveTool::findParts);
    connect(&studio.editor(), &Editor::pasted, this, [this] {
        studio_.hand().take(*this);
        choose(parts_.numberOf(studio_.host().facts()->parts.size() - 1).value_or(0));
    });
    connect(&studio.editor(), &Editor::pulledOut, this, [this](const std::string& segment) {
        studio_.hand().take(*this);
        choose(parts_.numberOf(segment).value_or(0));
    });
    connect(&studio.host(), &DocumentHost::opened, this, [this] { parts_.forget(); });
}

QString MoveTool::hint() const {
    if (count() == 0) {
        return tr("Nothing to move: paste what was cut (Shift+V) or pull a segment out (Ctrl+Shift+V).");
    }
    if (isTurningView_) {
        return tr("Turning the view. Press on the part to move that.");
    }
    if (before_ && !calm_.isActive()) {
        return tr("Let go to leave the part there. Esc puts it back.");
    }
    const QString text =
        tr("Drag the part to move it, with Shift to turn it, with Ctrl to roll it; the wheel scales it.");
    return count() > 1 ? text + tr(" Tab: the next part.") : text;
}

Qt::CursorShape MoveTool::cursor() const {
    return before_ ? Qt::ClosedHandCursor : isOver_ ? Qt::SizeAllCursor : Qt::OpenHandCursor;
}

// --- what is there

void MoveTool::findParts() {
    if (before_ || studio_.host().document() == nullptr || studio_.host().isLoading() ||
        studio_.host().facts()->isStrokeOpen() || studio_.host().facts()->isGrowing() ||
        &studio_.hand().tool() != this) {
        return;
    }
    if (identity_) {
        chosen_ = parts_.numberOf(*identity_, chosen_);
    }
    chosen_ = std::clamp(chosen_, 0, std::max(count() - 1, 0));
    identity_ = parts_.identityOf(chosen_);
    parts_.find();
    emit overlayChanged();
}

HeldPart MoveTool::held(int part) const {
    const auto& geometry = *studio_.host().geometry();
    glm::dvec3 centre = geometry.centreWorld();
    const Box3 box = parts_.box(part);
    if (!box.isEmpty()) {
        const glm::dvec3 voxel = 0.5 * glm::dvec3(box.lo + box.hi);
        centre = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
    }
    return {parts_.drawn(part), centre, geometry};
}

std::optional<render::Placement> MoveTool::place() const {
    return chosen_ < count() ? std::optional(parts_.put(chosen_)) : std::nullopt;
}

Overlays MoveTool::overlays() const {
    Overlays overlays;
    const auto* geometry = studio_.host().geometry();
    if (geometry == nullptr) {
        return overlays;
    }
    QFont font;
    font.setPixelSize(14);
    font.setBold(true);
    for (int part = 0; part < count(); ++part) {
        const bool isChosen = part == chosen_;
        const auto tint = isChosen ? Overlay::Tint::Idle : Overlay::Tint::Pen;
        const Box3 box = parts_.box(part);
        if (isChosen && !box.isEmpty()) {
            const glm::dmat4 place =
                render::worldFromPart(parts_.drawn(part), *geometry) * geometry->worldFromVoxel;
            overlays.push_back(
                {boxEdges(glm::dvec3(box.lo), glm::dvec3(box.hi), place, studio_.view()), tint, 0, 1});
        }
        const QPointF at = studio_.view().seenAt(held(part).centre());
        QPainterPath disc;
        disc.addEllipse(at, kHandle, kHandle);
        overlays.push_back({disc, tint, isChosen ? 0.6 : 0.2});
        const QString number = QString::number(part + 1);
        QPainterPath text;
        text.addText(QPointF(0, 0), font, number);
        text.translate(at - text.boundingRect().center());
        overlays.push_back({text, Overlay::Tint::Pen, 1, 0});
    }
    return overlays;
}

std::vector<QPointF> MoveTool::handles() const {
    std::vector<QPointF> places;
    places.reserve(std::size_t(count()));
    for (int part = 0; part < count(); ++part) {
        places.push_back(studio_.view().seenAt(held(part).centre()));
    }
    return places;
}

std::optional<int> MoveTool::handleAt(QPointF position) const {
    std::optional<int> nearest;
    double least = kReach;
    for (int part = 0; part < count(); ++part) {
        const QPointF way = studio_.view().seenAt(held(part).centre()) - position;
        const double distance = std::hypot(way.x(), way.y());
        if (distance <= least) {
            least = distance;
            nearest = part;
        }
    }
    return nearest;
}

bool MoveTool::isOverChosen(QPointF position) const {
    const Box3 box = parts_.box(chosen_);
    if (chosen_ >= count() || box.isEmpty()) {
        return false;
    }
    const glm::dvec2 scale = studio_.view().devicePerLogical();
    const QRectF seen =
        seenBox(box, parts_.drawn(chosen_), *studio_.host().geometry(), studio_.view().rays());
    return seen.adjusted(-kMargin, -kMargin, kMargin, kMargin)
        .contains(QPointF(position.x() * scale.x, position.y() * scale.y));
}

void MoveTool::choose(int part) {
    finishPending();
    chosen_ = std::clamp(part, 0, std::max(count() - 1, 0));
    identity_ = parts_.identityOf(chosen_);
    emit studio_.host().changed();
    emit overlayChanged();
}

bool MoveTool::next(bool forward) {
    if (count() < 2) {
        return false;
    }
    choose((chosen_ + (forward ? 1 : count() - 1)) % count());
    return true;
}

// --- by hand

void MoveTool::press(const Pen& pen) {
    finishPending();
    last_ = pen.position;
    const auto handle = count() > 0 ? handleAt(pen.position) : std::nullopt;
    if (handle && *handle != chosen_) {
        choose(*handle);
    }
    if (handle || isOverChosen(pen.position)) {
        begin();
    } else {
        isTurningView_ = true;
    }
    emit overlayChanged();
}

void MoveTool::begin() {
    if (!before_) {
        before_ = parts_.put(chosen_);
    }
}

void MoveTool::move(const Pen& pen) {
    const QPointF delta = pen.position - last_;
    if (isTurningView_) {
        studio_.camera().turn(delta);
    } else if (before_) {
        HeldPart part = held(chosen_);
        const auto rays = studio_.view().rays();
        const glm::dvec3 right = glm::normalize(rays.right);
        const glm::dvec3 up = glm::normalize(rays.up);
        if (pen.modifiers.testFlag(Qt::ShiftModifier)) {
            part.turn(up, kDegreesPerPixel * delta.x());
            part.turn(right, kDegreesPerPixel * delta.y());
        } else if (pen.modifiers.testFlag(Qt::ControlModifier)) {
            const QPointF centre = studio_.view().seenAt(part.centre());
            const QPointF from = last_ - centre;
            const QPointF to = pen.position - centre;
            const double angle = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
            part.turn(rays.forward, glm::degrees(angle)); // clockwise as seen, as y points down
        } else {
            const double mm = rays.pixelMm(part.centre()) * studio_.view().devicePerLogical().y;
            part.move(mm * (delta.x() * right - delta.y() * up));
        }
        show(part.place());
    }
    last_ = pen.position;
}

void MoveTool::release(const Pen& pen) {
    if (before_) {
        move(pen);
        commit();
    }
    isTurningView_ = false;
    hover(pen);
    emit overlayChanged();
}

void MoveTool::hover(const Pen& pen) {
    const bool isOver = count() > 0 && (handleAt(pen.position) || isOverChosen(pen.position));
    if (isOver != isOver_) {
        isOver_ = isOver;
        emit overlayChanged();
    }
}

bool MoveTool::wheel(double notches, const Pen& pen) {
    if (count() == 0 || !isOverChosen(pen.position)) {
        return false;
    }
    begin();
    HeldPart part = held(chosen_);
    part.scale(std::pow(kPerNotch, notches));
    show(part.place());
    calm_.start();
    return true;
}

void MoveTool::resetPlace() {
    if (place()) {
        studio_.editor().apply(parts_.moved(chosen_, {}));
        emit overlayChanged();
    }
}

// --- showing and keeping it

void MoveTool::show(const render::Placement& place) {
    parts_.draw(chosen_, place);
    emit overlayChanged();
}

// The document moves it itself, from where it was: so undo takes it back there.
void MoveTool::commit() {
    calm_.stop();
    if (!before_) {
        return;
    }
    const render::Placement before = *std::exchange(before_, std::nullopt);
    const render::Placement place = parts_.put(chosen_);
    const studio::Operation moved = parts_.moved(chosen_, place);
    parts_.letGo(chosen_, before);
    if (!(place == before)) {
        studio_.editor().apply(moved);
    }
    emit overlayChanged();
}

void MoveTool::drop() {
    calm_.stop();
    if (before_) {
        parts_.letGo(chosen_, *std::exchange(before_, std::nullopt));
    }
    emit overlayChanged();
}

void MoveTool::finishPending() {
    calm_.isActive() ? commit() : drop(); // what the wheel did was meant
}

void MoveTool::clear() {
    isTurningView_ = false;
    finishPending();
}

} // namespace vs::desktop
