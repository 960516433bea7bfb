// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "field/field.h"

#include <cstdint>
#include <vector>

namespace vs::field {

// The dark surroundings of what was scanned.
struct Air {
    double peak = 0; // its most frequent value
    double end = 0;  // where what is not air begins
};

// In a scan whose air is dark and noisy as that of MR is. It ends above the noise, and a quarter of the way
// from its peak to `object` at least, the threshold between all that is dark and all that is bright
// (volume::otsuThreshold); half of it where air was set to one value; nowhere beyond `object`. Weak signal,
// as a lower face far from the coil gives, lies between the two. Noise is told by the width of the peak.
// `counts` are those of equal bins over `range`, at best one
// for each value or thousands. (Magnitudes without signal are distributed after Rayleigh (Gudbjartsson and
// Patz 1995, "The Rician distribution of noisy MRI data"). Four half widths above the peak lie two of 100 000
// of them.)
Air findAir(const std::vector<std::uint32_t>& counts, const Range& range, double object);

// What transfer functions that suit many scans are fastened to, in ascending order.
struct Landmarks {
    double air = 0;      // its peak
    double tissue = 0;   // where it begins, above air's noise
    double darker = 0;   // a peak: grey matter in T1-weighted MR of a head, fat in CT
    double brighter = 0; // the peak that goes with it: white matter, and muscle in CT
    double top = 0;      // the 99.9th percentile, or more
};

// Tissue's peaks are looked for in the middle half of the grid along each axis, where there is little scalp,
// fat and muscle of the neck, which have peaks too. Counts are smoothed by a Gaussian as wide as a 64th of
// the range between the 0.1st and the 99.9th percentile (sigma). Of all pairs of which the darker one lies
// 0.6 to 0.93 of the way from air to the brighter one, and neither is lower than 0.15 of the tallest peak, it
// is the pair that is highest together. Where there is no such pair, the tallest peak is the brighter one,
// and the darker one is taken to lie at 0.76 of the way, as that of grey matter does in most scans.
Landmarks findLandmarks(const Field& field);

inline constexpr Range kAirAndWaterHu{-1000, 0};

// The values of air and of water in a CT scan, so that Hounsfield units can be told where the scan's values
// are others: from air's peak, taken for -1000 HU, and the brighter peak of tissue, taken for 40. Eight-bit
// scans have whatever scale their maker chose. Wider ones have values below -500 or are Hounsfield units
// moved up, which is so when 1040 +- 15 % lie between the peaks; all others are taken for Hounsfield units
// without the values of air, as prepared scans often are.
Range findAirAndWater(const Landmarks& landmarks, const Range& range);

} // namespace vs::field
