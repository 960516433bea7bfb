// SPDX-License-Identifier: Apache-2.0
#include "model/texts/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vs::desktop {

namespace {

struct Unit {
    double size; // in the quantity's own unit
    const char* name;
};

// The largest unit that is no larger than the quantity; the last one for what is smaller.
template <std::size_t n>
const Unit& unitFor(double quantity, const std::array<Unit, n>& units) {
    const auto fits = [quantity](const Unit& unit) { return quantity >= unit.size; };
    const auto found = std::find_if(units.begin(), units.end(), fits);
    return found != units.end() ? *found : units.back();
}

// With three digits that count.
QString withUnit(double quantity, const Unit& unit) {
    const double value = quantity / unit.size;
    const int decimals = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
    return QString("%1 %2").arg(value, 0, 'f', decimals).arg(QString::fromUtf8(unit.name));
}

// Places are written in a unit of which a step of the scan is some hundredths at least.
constexpr std::array<Unit, 4> kPlaceUnits{{{1e3, "m"}, {1, "mm"}, {1e-3, "µm"}, {1e-6, "nm"}}};
const Unit& unitOfPlaces(double stepMm) { return unitFor(20 * stepMm, kPlaceUnits); }

} // namespace

QString volumeText(double millilitres) {
    constexpr double kMicrolitres = 0.01; // ml, up to which they are used
    constexpr double kLitres = 1e4;
    if (millilitres == 0 || (millilitres >= kMicrolitres && millilitres < kLitres)) {
        return QString("%1 ml").arg(millilitres, 0, 'f', millilitres < 9.995 ? 2 : 1);
    }
    constexpr std::array<Unit, 6> units{
        {{1e6, "m³"}, {1e3, "l"}, {1e-3, "µl"}, {1e-6, "nl"}, {1e-9, "pl"}, {1e-12, "fl"}}};
    return withUnit(millilitres, unitFor(millilitres, units));
}

QString placeText(double mm, double stepMm) {
    return QString::number(std::abs(mm) / unitOfPlaces(stepMm).size, 'f', 1);
}

QString placeUnit(double stepMm) { return QString::fromUtf8(unitOfPlaces(stepMm).name); }

} // namespace vs::desktop
