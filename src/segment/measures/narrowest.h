// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/measures/vessel.h"

#include <cstddef>
#include <optional>

namespace vs::segment {

// The place of a vessel that is narrowest for where it is.
struct Narrowest {
    std::size_t index = 0; // of Vessel::points
    double diameterMm = 0;
    double referenceDiameterMm = 0; // that the vessel would have here if it were healthy
    double stenosisPercent = 0;     // 100 (1 - diameter / reference), of the diameter, not of the area
};

// Finds where the diameter falls shortest of the reference, which lies on the line between the healthy
// diameters on both sides: a vessel that grows thinner along its way has no stenosis for that. The healthy
// diameter of a side is exceeded by the widest quarter of its next ten (median) diameters of length, so that
// neither a short bulge nor the stenosis itself has a say in it. Nothing where the vessel is too short to
// have a diameter of length on both sides of any place.
std::optional<Narrowest> narrowestOf(const Vessel& vessel);

} // namespace vs::segment
