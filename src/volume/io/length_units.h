// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace vs::volume {

// Millimetres of a unit of length, as OME-Zarr names it (UDUNITS: "micrometer"), OME-XML ("um", the micro
// sign in UTF-8) and ImageJ ("micron", the micro sign also as an escape or in Latin-1). Nothing: it is not
// known.
std::optional<double> millimetresOf(const std::string& unit);

} // namespace vs::volume
