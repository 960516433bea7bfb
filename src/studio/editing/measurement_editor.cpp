// SPDX-License-Identifier: Apache-2.0
#include "studio/editing/measurement_editor.h"

#include "base/error.h"

#include <algorithm>

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
