// SPDX-License-Identifier: Apache-2.0
#include "tools/slice_pen.h"

#include "model/segments/growth_controller.h"
#include "model/slices/slice_controller.h"
#include "model/studio/studio_controller.h"
#include "studio/document/document_facts.h"
#include "tools/measure_tool.h"
#include "tools/paint_tool.h"
#include "tools/seed_tool.h"

#include <utility>

namespace vs::desktop {

SlicePen::SlicePen(StudioController& studio, SeedTool& seed, PaintTool& paint, MeasureTool& measure)
    : QObject(&studio), studio_(studio), seed_(seed), paint_(paint), measure_(measure) {
    // A tool that is left, or told to clear, drops the stroke in hand.
    connect(&seed_, &Tool::overlayChanged, this, &SlicePen::cancel);
    connect(&paint_, &Tool::overlayChanged, this, &SlicePen::cancel);
    connect(&paint_, &Tool::settingsChanged, this, &SlicePen::changed);
}

SlicePen::Use SlicePen::use() const {
    const Tool* tool = &studio_.hand().tool();
    return tool == &seed_      ? Use::Seed
           : tool == &paint_   ? Use::Paint
           : tool == &measure_ ? Use::Measure
                               : Use::Crosshair;
}

bool SlicePen::takesRightButton() const { return use() == Use::Paint; }

std::optional<double> SlicePen::radiusMm(Kind kind) const {
    switch (use()) {
    case Use::Crosshair:
    case Use::Measure:
        return std::nullopt;
    case Use::Seed: // as wide as on the 3D view
        return 0.5 * seed_.width() * studio_.slices().view(kind).pixelMm *
               studio_.slices().pixelsPerLogical(kind);
    case Use::Paint:
        break;
    }
    return paint_.radiusMm();
}

Overlay::Tint SlicePen::tint(bool isReversed) const {
    if (use() == Use::Seed) {
        return seed_.isReversed() ? Overlay::Tint::Cutting : Overlay::Tint::Seed;
    }
    return paint_.isToAdd() != isReversed ? Overlay::Tint::Idle : Overlay::Tint::Cutting;
}

bool SlicePen::press(Kind kind, glm::dvec2 place, bool isReversed, Qt::KeyboardModifiers modifiers) {
    if (studio_.host().document() == nullptr || studio_.host().isLoading() ||
        studio_.host().facts()->isStrokeOpen()) {
        return false;
    }
    if (use() == Use::Crosshair || modifiers.testFlag(Qt::ShiftModifier)) {
        isLeading_ = true;
        lead(kind, place);
        return true;
    }
    isMeasuring_ = use() == Use::Measure;
    if (isMeasuring_) {
        measuredSlice_ = indexOf(kind);
        measure_.begin(worldAt(kind, place, measuredSlice_));
        return true;
    }
    isReversed_ =
        use() == Use::Seed ? seed_.isReversed() : isReversed != modifiers.testFlag(Qt::ControlModifier);
    const SliceController& slices = studio_.slices();
    stroke_ = Stroke{kind,
                     {place},
                     radiusMm(kind).value_or(0),
                     tint(isReversed_),
                     slices.crosshair()[slices.geometry(kind).axis()]};
    emit changed();
    return true;
}

void SlicePen::lead(Kind kind, glm::dvec2 place) {
    SliceController& slices = studio_.slices();
    const render::SliceGeometry slice = slices.geometry(kind);
    slices.setCrosshair(slice.voxelAt(place, slices.crosshair()[slice.axis()]));
}

void SlicePen::move(Kind kind, glm::dvec2 place) {
    if (isLeading_) {
        lead(kind, place);
    } else if (isMeasuring_) {
        measure_.lead(worldAt(kind, place, measuredSlice_));
    } else if (stroke_ && stroke_->kind == kind) {
        // Places nearer than a small part of brush and pixel would change nothing.
        const double apart = std::max(0.1 * stroke_->radiusMm, 0.25 * studio_.slices().view(kind).pixelMm);
        if (glm::length(place - stroke_->places.back()) >= apart) {
            stroke_->places.push_back(place);
            emit changed();
        }
    }
}

int SlicePen::indexOf(Kind kind) const {
    const SliceController& slices = studio_.slices();
    return slices.crosshair()[slices.geometry(kind).axis()];
}

glm::dvec3 SlicePen::worldAt(Kind kind, glm::dvec2 place, int index) const {
    const glm::dvec3 voxel = studio_.slices().geometry(kind).voxelAt(place, index);
    return glm::dvec3(studio_.host().geometry()->worldFromVoxel * glm::dvec4(voxel, 1.0));
}

studio::Trail SlicePen::trail() const {
    const render::SliceGeometry slice = studio_.slices().geometry(stroke_->kind);
    studio::Trail trail;
    trail.radiusMm = stroke_->radiusMm;
    trail.axis = slice.axis();
    for (const glm::dvec2 place : stroke_->places) {
        trail.points.push_back(slice.voxelAt(place, stroke_->index));
    }
    return trail;
}

void SlicePen::hover(Kind kind, glm::dvec2 place) {
    if (use() == Use::Measure) {
        measure_.lead(worldAt(kind, place, indexOf(kind)));
    }
}

void SlicePen::release(bool isDrag) {
    isLeading_ = false;
    if (std::exchange(isMeasuring_, false)) {
        measure_.end(isDrag);
    }
    if (!stroke_) {
        return;
    }
    const studio::Trail drawn = trail();
    stroke_.reset();
    if (use() == Use::Seed && isReversed_) {
        studio_.editor().apply(studio::PaintSegment{false, drawn, {}});
    } else if (use() == Use::Seed) {
        studio::Seed seed;
        seed.trails = {drawn};
        seed.canvas = studio_.view().canvas();
        studio_.growth().addSeeds(seed);
    } else {
        paint_.paint(drawn, isReversed_);
    }
    emit changed();
}

void SlicePen::cancel() {
    isLeading_ = isMeasuring_ = false;
    if (stroke_) {
        stroke_.reset();
        emit changed();
    }
}

} // namespace vs::desktop
