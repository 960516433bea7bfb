// SPDX-License-Identifier: Apache-2.0
#include "volume/io/length_units.h"

#include <map>

namespace vs::volume {

std::optional<double> millimetresOf(const std::string& unit) {
    static const std::map<std::string, double> known{
        {"picometer", 1e-9},  {"pm", 1e-9},      {"angstrom", 1e-7},   {"\xC3\x85", 1e-7},
        {"nanometer", 1e-6},  {"nm", 1e-6},      {"micrometer", 1e-3}, {"um", 1e-3},
        {"micron", 1e-3},     {"microns", 1e-3}, {"\\u00B5m", 1e-3},   {"\xC2\xB5m", 1e-3},
        {"\xCE\xBCm", 1e-3},  {"\xB5m", 1e-3},   {"millimeter", 1.0},  {"mm", 1.0},
        {"centimeter", 10.0}, {"cm", 10.0},      {"decimeter", 100.0}, {"meter", 1000.0},
        {"m", 1000.0},        {"inch", 25.4}};
    const auto found = known.find(unit);
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

} // namespace vs::volume
