// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/measurement_editor.h"

#include "base/error.h"
#include "segment/measures/vessel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vs::studio {

namespace {

// What is cut away, in voxels: those of which at least a half is.
std::size_t voxelsCut(const sculpt::Sculpture& sculpture) {
    std::size_t voxels = 0;
    for (const Box3& brick : sculpture.touchedBricks()) {
        const auto values = sculpture.values(brick);
        voxels += std::size_t(
            std::count_if(values.begin(), values.end(), [](float value) { return value >= 0.5F; }));
    }
    return voxels;
}

// The label at a voxel or, if there is none, of the nearest voxel about it that has one; 0: there is none
// near.
std::uint8_t labelNear(const std::vector<std::uint8_t>& labels, glm::ivec3 dims, glm::ivec3 voxel) {
    constexpr int reach = 3; // voxels: a click on a surface hits the voxel before it
    const Box3 around = intersect({voxel - reach, voxel + reach + 1}, {glm::ivec3(0), dims});
    std::uint8_t found = 0;
    int nearest = std::numeric_limits<int>::max();
    forEachVoxel(around, [&](glm::ivec3 v, std::size_t) {
        const glm::ivec3 way = v - voxel;
        const int distance2 = way.x * way.x + way.y * way.y + way.z * way.z;
        const std::size_t i =
            (std::size_t(v.z) * std::size_t(dims.y) + std::size_t(v.y)) * std::size_t(dims.x) +
            std::size_t(v.x);
        if (labels[i] != 0 && distance2 < nearest) {
            nearest = distance2;
            found = labels[i];
        }
    });
    return found;
}

segment::VoxelSet setOf(const std::vector<std::uint8_t>& labels, glm::ivec3 dims, std::uint8_t label) {
    segment::VoxelSet set{{glm::ivec3(0), dims}, labels};
    for (std::uint8_t& voxel : set.inside) {
        voxel = voxel == label ? 1 : 0;
    }
    return set.tight();
}

// A session keeps no more digits than tell something: `step` is what 1 is of.
double rounded(double value, double step = 1) {
    constexpr double perStep = 1e4;
    return std::round(value / step * perStep) / perStep * step;
}

// Finds the vessel between an operation's points.
void followVessel(Measure& op, const Contents& contents) {
    if (!contents.region.exists()) {
        throw Error("there is no segment yet that a vessel could be; grow it first");
    }
    const volume::GridGeometry& geometry = contents.scan.volume.geometry;
    const auto labels = contents.region.labelMap();
    const std::array<glm::ivec3, 2> ends{glm::ivec3(glm::round(op.points[0])),
                                         glm::ivec3(glm::round(op.points[1]))};
    const SegmentInfo* info = op.segment ? contents.segments.find(*op.segment) : nullptr;
    if (op.segment && info == nullptr) {
        throw Error("there is no segment {}", *op.segment);
    }
    if (info == nullptr) {
        const std::uint8_t label = labelNear(labels, geometry.dims, ends[0]);
        const auto& all = contents.segments.segments;
        const auto found = std::find_if(
            all.begin(), all.end(), [label](const SegmentInfo& segment) { return segment.label == label; });
        info = found == all.end() ? &contents.segments.working() : &*found;
    }
    op.segment = info->name;
    const segment::Vessel vessel = segment::vesselBetween(setOf(labels, geometry.dims, info->label), geometry,
                                                          ends[0], ends[1], &contents.scan.volume);
    op.centreline.clear();
    op.diametersMm.clear();
    for (const segment::VesselPoint& point : vessel.points) {
        op.centreline.emplace_back(rounded(point.voxel.x), rounded(point.voxel.y), rounded(point.voxel.z));
        op.diametersMm.push_back(rounded(point.diameterMm, geometry.stepMm()));
    }
}

} // namespace

void MeasurementEditor::show(const Measurements& measurements) { contents_.measurements = measurements; }

void MeasurementEditor::change(const Operation& operation, std::vector<Measure> measurements) {
    Edit edit{shared(operation), {}, {}};
    edit.measurementsBefore = contents_.measurements;
    edit.measurementsAfter = std::make_shared<const std::vector<Measure>>(std::move(measurements));
    const Measurements after = edit.measurementsAfter;
    contents_.remember(std::move(edit));
    ++contents_.sliceChanges; // rays show none of it
    show(after);
}

Outcome MeasurementEditor::run(Measure& op) {
    if (const Fault fault = op.faultOf(); !fault.wanted.empty()) {
        throw Error("{}: {}", fault.place, fault.wanted);
    }
    if (contents_.measurements->size() == kMostMeasurements) {
        throw Error("there are {} measurements already; remove some", kMostMeasurements);
    }
    if (op.kind == Measure::Kind::Cut) {
        op.voxelsCut = double(voxelsCut(contents_.sculpture));
    }
    if (op.kind == Measure::Kind::Vessel) {
        followVessel(op, contents_);
    }
    const Measured found = measured(op, contents_.scan.volume);
    if (found.value <= 0) {
        throw op.kind == Measure::Kind::Cut ? Error("nothing is cut away that could be measured")
                                            : Error("nothing to measure: the points lie upon one another");
    }
    auto measurements = *contents_.measurements;
    measurements.push_back(op);
    change(op, std::move(measurements));
    return {{}, 0, 0, say("%1", labelOf(found, contents_.scan.volume.geometry))};
}

Outcome MeasurementEditor::run(RemoveMeasurement& op) {
    auto measurements = *contents_.measurements;
    if (op.measurement && *op.measurement >= int(measurements.size())) {
        throw Error("there is no measurement {}; there are {}, counted from 0", *op.measurement,
                    measurements.size());
    }
    if (measurements.empty()) {
        throw Error("there is no measurement to remove");
    }
    if (op.measurement) {
        measurements.erase(measurements.begin() + *op.measurement);
    } else {
        measurements.clear();
    }
    change(op, std::move(measurements));
    return {};
}

} // namespace vs::studio
