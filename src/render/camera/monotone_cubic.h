// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace vs::render {

// How a motion through key frames begins and ends.
enum class Ends {
    Rest, // at rest: it sets out and arrives gently
    Run,  // at the speed that the neighbouring keys suggest
    Loop, // going on from the last key as from the first: only differences between values are looked at, so
          // that angles may have turned meanwhile
};

// A smooth curve through key values at increasing times, read at time `t`. It has a continuous speed, passes
// exactly through the values, lies between neighbouring ones everywhere (so it never overshoots, and rests
// where two are equal), and is straight where they are evenly spread. Before the first time and after the
// last it has the values there. For one number of many that change together: an angle, the logarithm of a
// zoom, an end of the displayed range, a generation. (Fritsch and Carlson 1980)
double monotoneCubic(std::span<const double> times, std::span<const double> values, double t,
                     Ends ends = Ends::Rest);

} // namespace vs::render
