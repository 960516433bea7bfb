// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/narrowest.h"
#include "studio/operations/measuring.h"
#include "volume/measures/figures.h"

#include <memory>
#include <optional>
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
    std::vector<glm::dvec3> world; // its points, of a vessel those of its centreline: LPS mm
    double value = 0;              // mm, degrees, mm^2 or ml
    volume::UnderOutline under;    // of an area
    // A vessel has these, at each point of its centreline: how far along that is, and the vessel's diameter
    // there; and where it is narrower than beside.
    std::vector<double> alongMm = {};
    std::vector<double> diametersMm = {};
    std::optional<segment::Narrowest> narrowest = {};

    [[nodiscard]] bool isArea() const { return measure.kind == Measure::Kind::Area; }
    [[nodiscard]] bool isVessel() const { return measure.kind == Measure::Kind::Vessel; }
    // A vessel whose narrowest place is worth to be pointed out: healthy ones vary by a few percent.
    [[nodiscard]] bool isNarrowed() const {
        constexpr double leastPercent = 10;
        return narrowest && narrowest->stenosisPercent >= leastPercent;
    }
};

Measured measured(const Measure& measure, const volume::Volume& volume);
// All of a list. What stands at the same place in `known`, on the same grid, is not measured again.
std::vector<Measured> allMeasured(std::span<const Measure> measures, const volume::Volume& volume,
                                  std::span<const Measured> known = {});

// What people read, with a digit for each tenth of the scan's smallest spacing and no more: "12.3 mm",
// "90.5°", "153 mm²". Of areas `valuesOf` says what their values are like: "105 ± 12"; of vessels
// `narrowestOf` what their narrowest place is like beside its neighbours: "⌀ 1.8 mm (−52 %)".
std::string labelOf(const Measured& measured, const volume::GridGeometry& geometry);
std::string valuesOf(const Measured& measured);
std::string narrowestOf(const Measured& measured, const volume::GridGeometry& geometry);
std::string lengthText(double mm, const volume::GridGeometry& geometry);

// Comma-separated values with all digits: one line a measurement, names of fields with their units in the
// first; points are those of the world, and a line each in one field.
std::string csvOf(std::span<const Measured> measurements);
// A line for each point of each vessel's centreline: the measurement's number, how far along, the diameter,
// and the place.
std::string vesselsCsvOf(std::span<const Measured> measurements);

} // namespace vs::studio
