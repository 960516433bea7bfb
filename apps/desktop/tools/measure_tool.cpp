// SPDX-License-Identifier: Apache-2.0
#include "tools/measure_tool.h"

#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "studio/document/surface_queries.h"
#include "tools/camera_tool.h"

#include <QLineF>

namespace vs::desktop {

namespace {
constexpr double kDragPixels = 4;   // less is a click
constexpr double kNearSteps = 0.25; // places of a path that are nearer would change nothing
} // namespace

MeasureTool::MeasureTool(StudioController& studio, CameraTool& camera) : StudioTool(studio), camera_(camera) {
    connect(&studio_.host(), &DocumentHost::opened, this, &MeasureTool::drop);
    connect(&studio_.host(), &DocumentHost::closed, this, &MeasureTool::drop);
    connect(&studio_.host(), &DocumentHost::corrected, this, &MeasureTool::drop);
    connect(&studio_.host(), &DocumentHost::changed, this, &MeasureTool::tell);
}

const std::vector<studio::Measured>& MeasureTool::measurements() const {
    static const std::vector<studio::Measured> none;
    return studio_.host().geometry() == nullptr ? none : *studio_.host().facts()->measured;
}

std::optional<studio::Measured> MeasureTool::inHand() const {
    if (places_.empty()) {
        return std::nullopt;
    }
    studio::Measured measured;
    measured.measure.kind = kind_;
    measured.world = places_;
    if (kind_ == Kind::Angle) {
        measured.value = places_.size() == 3 ? volume::angleDegrees(places_[0], places_[1], places_[2]) : 0;
    } else if (kind_ != Kind::Area) {
        measured.value = volume::lengthMm(places_);
    }
    return measured;
}

QString MeasureTool::labelOf(const studio::Measured& measured) const {
    const QString label = QString::fromStdString(studio::labelOf(measured, *studio_.host().geometry()));
    const QString values = QString::fromStdString(studio::valuesOf(measured));
    return values.isEmpty() ? label : tr("%1, %2").arg(label, values);
}

QString MeasureTool::narrowestOf(const studio::Measured& measured) const {
    return QString::fromStdString(studio::narrowestOf(measured, *studio_.host().geometry()));
}

QString MeasureTool::hint() const {
    if (isTurning_) {
        return kind_ == Kind::Area ? tr("Turning the view: areas are drawn on slices.")
                                   : tr("Turning the view: there is no surface where the drag began.");
    }
    if (!places_.empty() && isDrawn()) {
        return kind_ == Kind::Path ? tr("Draw along it, and let go at its end. Esc drops the measurement.")
                                   : tr("Draw around it, and let go to close the outline. Esc drops it.");
    }
    if (!places_.empty() && isHeld_) {
        return isFirst_ ? tr("Drag to the second place, or let go and click it. Esc drops the measurement.")
                        : tr("Let go to measure to here. Esc drops the measurement.");
    }
    if (!places_.empty()) {
        return places_.size() == 2 ? tr("Click the second place. Esc drops the measurement.")
                                   : tr("Click the third place. Esc drops the measurement.");
    }
    switch (kind_) {
    case Kind::Angle:
        return tr("Click three places, on the surface or on a slice: the angle is the one at the second.");
    case Kind::Path:
        return tr("Draw along what is to be measured, on the surface or on a slice.");
    case Kind::Area:
        return tr("Draw around what is to be measured, on a slice: an area lies in one.");
    case Kind::Vessel:
        return tr("Click two places along a segment that is a vessel, on the surface or on a slice.");
    case Kind::Distance:
    case Kind::Cut:
        break;
    }
    return tr("Click two places, on the surface or on a slice, or drag from one to the other.");
}

void MeasureTool::tell() {
    emit overlayChanged();
    emit changed();
}

void MeasureTool::drop() {
    places_.clear();
    isHeld_ = false;
    tell();
}

void MeasureTool::setKind(Kind kind) {
    kind_ = kind;
    drop();
}

// --- one measurement

void MeasureTool::begin(glm::dvec3 world) {
    isHeld_ = true;
    isFirst_ = places_.empty();
    if (isFirst_) {
        places_ = isDrawn() ? std::vector{world} : std::vector{world, world};
    }
    lead(world);
}

void MeasureTool::lead(glm::dvec3 world) {
    if (places_.empty() || (isDrawn() && !isHeld_)) {
        return;
    }
    if (!isDrawn()) {
        places_.back() = world;
    } else if (glm::distance(places_.back(), world) >= kNearSteps * studio_.host().geometry()->stepMm()) {
        places_.push_back(world);
    }
    tell();
}

void MeasureTool::end(bool isDrag) {
    isHeld_ = false;
    if (places_.empty()) {
        return;
    }
    if (isDrawn() || isDrag || !isFirst_) {
        fix();
    }
    tell();
}

// The last place stays where it is; the next one follows the pen. What is drawn is done.
void MeasureTool::fix() {
    if (isDrawn()) {
        const std::size_t least = kind_ == Kind::Path ? 2 : 3;
        places_.size() >= least ? finish() : drop();
    } else if (places_.size() == (kind_ == Kind::Angle ? 3U : 2U)) {
        inHand()->value > 0 ? finish() : drop();
    } else {
        places_.push_back(places_.back());
    }
}

void MeasureTool::finish() {
    const glm::dmat4 voxelFromWorld = studio_.host().geometry()->voxelFromWorld();
    studio::Measure measure{kind_, {}, {}};
    for (const glm::dvec3& place : places_) {
        measure.points.emplace_back(voxelFromWorld * glm::dvec4(place, 1));
    }
    places_.clear();
    studio_.editor().apply(measure);
}

void MeasureTool::measureCut() { studio_.editor().apply(studio::Measure{Kind::Cut, {}, {}}); }

void MeasureTool::clear() {
    isTurning_ = false;
    drop();
}

void MeasureTool::removeLast() {
    if (!measurements().empty()) {
        studio_.editor().apply(studio::RemoveMeasurement{int(measurements().size()) - 1});
    }
}

void MeasureTool::removeAll() {
    if (!measurements().empty()) {
        studio_.editor().apply(studio::RemoveMeasurement{});
    }
}

// --- in the 3D view

std::optional<glm::dvec3> MeasureTool::surfaceAt(QPointF position) {
    std::optional<studio::Probe> found;
    const glm::dvec2 pixel = glm::dvec2(position.x(), position.y()) * studio_.view().devicePerLogical();
    const auto viewport = studio_.view().canvas().viewport;
    studio_.host().workLong([&] { found = studio_.host().document()->surface().probe(pixel, viewport); });
    return found ? std::optional(found->world) : std::nullopt;
}

void MeasureTool::press(const Pen& pen) {
    pressed_ = pen.position;
    // An area lies in a slice: on the surface none is drawn.
    const auto world = kind_ == Kind::Area ? std::nullopt : surfaceAt(pen.position);
    isTurning_ = !world;
    if (world) {
        begin(*world);
    } else {
        camera_.press(pen);
        tell();
    }
}

void MeasureTool::move(const Pen& pen) {
    if (isTurning_) {
        camera_.move(pen);
    } else if (const auto world = surfaceAt(pen.position)) {
        lead(*world);
    }
}

void MeasureTool::release(const Pen& pen) {
    if (isTurning_) {
        camera_.release(pen);
        isTurning_ = false;
        tell();
    } else {
        end(QLineF(pressed_, pen.position).length() > kDragPixels);
    }
}

void MeasureTool::hover(const Pen& pen) {
    if (!places_.empty() && !isDrawn() && studio_.isSettled()) {
        if (const auto world = surfaceAt(pen.position)) {
            lead(*world);
        }
    }
}

} // namespace vs::desktop
