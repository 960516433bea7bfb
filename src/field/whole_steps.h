// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "volume/grid/volume.h"

#include <cmath>
#include <optional>

namespace vs::field {

// Floats of a volume that stand for whole numbers: files store those with a slope and an intercept. On the
// device they take no more room than the whole numbers do.
struct WholeSteps {
    double slope = 1; // value = slope * stored + intercept, rounded to float
    double intercept = 0;
    double lowest = 0; // the stored number of the lowest value
    int count = 0;     // of numbers from the lowest value's to the highest's: at most 65536

    // From one value to the next.
    [[nodiscard]] double step() const { return std::abs(slope); }
    // How many steps a value lies above the lowest.
    [[nodiscard]] int stepsTo(float value) const {
        return int(std::abs(std::round((double(value) - intercept) / slope) - lowest));
    }
};

// Nothing where the volume's file had no scale, or where a value is not exactly what a whole number stands
// for.
std::optional<WholeSteps> wholeStepsOf(const volume::Volume& volume);

} // namespace vs::field
