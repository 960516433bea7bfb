// SPDX-License-Identifier: Apache-2.0
#include "tools/measure_tool.h"

#include "model/studio/studio_controller.h"
#include "model/texts/quantities.h"
#include "studio/document/surface_queries.h"
#include "tools/camera_tool.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace vs::desktop {

namespace {
constexpr double kDragPixels = 4; // less is a click
} // namespace

double valueOf(const Measurement& measurement) {
    const auto& places = measurement.places;
    if (places.size() < 2) {
        return 0;
    }
    if (!measurement.isAngle()) {
        return glm::length(places[1] - places[0]);
    }
    const glm::dvec3 a = places[0] - places[1];
    const glm::dvec3 b = places[2] - places[1];
    // By sine and cosine: exact for small angles too.
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

QString labelOf(const Measurement& measurement) {
    const double value = valueOf(measurement);
    if (measurement.isAngle()) {
        return QString("%1°").arg(value, 0, 'f', 1);
    }
    return lengthText(value);
}

MeasureTool::MeasureTool(StudioController& studio, CameraTool& camera) : StudioTool(studio), camera_(camera) {
    connect(&studio_.host(), &DocumentHost::opened, this, &MeasureTool::removeAll);
    connect(&studio_.host(), &DocumentHost::closed, this, &MeasureTool::removeAll);
    connect(&studio_.host(), &DocumentHost::corrected, this, &MeasureTool::followVoxels);
}

// Places stay on the voxels that they were put on, wherever those lie now.
void MeasureTool::followVoxels(const volume::GridGeometry& before) {
    const glm::dmat4 nowFromBefore = studio_.host().geometry()->worldFromVoxel * before.voxelFromWorld();
    const auto follow = [&](Measurement& measurement) {
        for (glm::dvec3& place : measurement.places) {
            place = glm::dvec3(nowFromBefore * glm::dvec4(place, 1));
        }
    };
    std::for_each(measurements_.begin(), measurements_.end(), follow);
    inHand_.reset();
    tell();
}

QString MeasureTool::hint() const {
    if (isTurning_) {
        return tr("Turning the view: there is no surface where the drag began.");
    }
    if (inHand_ && isHeld_) {
        return isFirst_ ? tr("Drag to the second place, or let go and click it. Esc drops the measurement.")
                        : tr("Let go to measure to here. Esc drops the measurement.");
    }
    if (inHand_) {
        return inHand_->places.size() == 2 ? tr("Click the second place. Esc drops the measurement.")
                                           : tr("Click the third place. Esc drops the measurement.");
    }
    return measuresAngles_
               ? tr("Click three places, on the surface or on a slice: the angle is the one at the second.")
               : tr("Click two places, on the surface or on a slice, or drag from one to the other.");
}

void MeasureTool::tell() {
    emit overlayChanged();
    emit changed();
}

void MeasureTool::setMeasuresAngles(bool angles) {
    measuresAngles_ = angles;
    inHand_.reset();
    tell();
}

// --- one measurement

void MeasureTool::begin(glm::dvec3 world) {
    isHeld_ = true;
    isFirst_ = !inHand_;
    if (isFirst_) {
        inHand_ = Measurement{{world, world}};
    }
    lead(world);
}

void MeasureTool::lead(glm::dvec3 world) {
    if (inHand_) {
        inHand_->places.back() = world;
        tell();
    }
}

void MeasureTool::end(bool isDrag) {
    isHeld_ = false;
    if (inHand_ && (isDrag || !isFirst_)) {
        fix();
    }
    tell();
}

// The last place stays where it is; the next one follows the pen.
void MeasureTool::fix() {
    const std::size_t wanted = measuresAngles_ ? 3 : 2;
    if (inHand_->places.size() == wanted) {
        if (valueOf(*inHand_) > 0) {
            measurements_.push_back(*inHand_);
        }
        inHand_.reset();
    } else {
        inHand_->places.push_back(inHand_->places.back());
    }
    tell();
}

void MeasureTool::clear() {
    inHand_.reset();
    isTurning_ = false;
    tell();
}

void MeasureTool::removeLast() {
    if (!measurements_.empty()) {
        measurements_.pop_back();
    }
    tell();
}

void MeasureTool::removeAll() {
    measurements_.clear();
    inHand_.reset();
    tell();
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
    const auto world = surfaceAt(pen.position);
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
    if (inHand_ && studio_.isSettled()) {
        if (const auto world = surfaceAt(pen.position)) {
            lead(*world);
        }
    }
}

} // namespace vs::desktop
