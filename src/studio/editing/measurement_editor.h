// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/editing/contents.h"
#include "studio/editing/outcome.h"

namespace vs::studio {

// Keeps the list of measurements.
class MeasurementEditor {
public:
    // It must outlive it.
    explicit MeasurementEditor(Contents& contents) : contents_(contents) {}

    Outcome run(Measure& op);
    Outcome run(RemoveMeasurement& op);
    // For undo and redo.
    void show(const Measurements& measurements);

private:
    void change(const Operation& operation, std::vector<Measure> measurements);

    Contents& contents_;
};

} // namespace vs::studio
