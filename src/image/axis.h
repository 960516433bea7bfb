// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"

#include <string>
#include <vector>

namespace vs::image {

// At most `most` (two or more) evenly spaced round numbers within a range: multiples of 1, 2, 2.5 or 5 times
// a power of ten. As many as that allows; none if the range is empty.
std::vector<double> roundTicks(const Range& range, int most);

// The powers of ten within a range of positive numbers, thinned out evenly to at most `most`.
std::vector<double> decadeTicks(const Range& range, int most);

// A number as it stands at an axis: "-0.5" with a real minus sign, "12 000" with thin spaces.
std::string tickLabel(double value);
// A power of ten: "1", "10", "10⁵".
std::string decadeLabel(double value);

} // namespace vs::image
