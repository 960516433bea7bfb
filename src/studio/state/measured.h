// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/operations/measuring.h"
#include "volume/measures/figures.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vs::studio {

// The measurements of a document, in the order in which they were made. Shared: it is replaced, never
// changed.
using Measurements = std::shared_ptr<const std::vector<Measure>>;

// What a measurement comes to.
struct Measured {
    Measure measure;
    std::vector<glm::dvec3> world; // its points: LPS mm
    double value = 0;              // mm, degrees, mm^2 or ml
    volume::UnderOutline under;    // of an area

    [[nodiscard]] bool isArea() const { return measure.kind == Measure::Kind::Area; }
};

Measured measured(const Measure& measure, const volume::Volume& volume);

// What people read, with a digit for each tenth of the scan's smallest spacing and no more: "12.3 mm",
// "90.5°", "153 mm²". Of areas `valuesOf` says what their values are like: "105 ± 12".
std::string labelOf(const Measured& measured, const volume::GridGeometry& geometry);
std::string valuesOf(const Measured& measured);

// Comma-separated values with all digits: one line a measurement, names of fields with their units in the
// first; points are those of the world, and a line each in one field.
std::string csvOf(std::span<const Measured> measurements);

} // namespace vs::studio
