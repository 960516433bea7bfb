// SPDX-License-Identifier: Apache-2.0
#include "studio/state/measured.h"

#include "base/csv.h"
#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vs::studio {

namespace {

struct Unit {
    double mm; // in one of it
    const char* name;
};

// The largest of which the scan's step is some hundredths at least.
const Unit& unitFor(double stepMm) {
    static constexpr std::array<Unit, 4> units{{{1e3, "m"}, {1, "mm"}, {1e-3, "µm"}, {1e-6, "nm"}}};
    constexpr double kSteps = 20;
    const auto found = std::find_if(units.begin(), units.end(),
                                    [&](const Unit& unit) { return kSteps * stepMm >= unit.mm; });
    return found != units.end() ? *found : units.back();
}

std::string lengthLabel(double mm, double stepMm) {
    const Unit& unit = unitFor(stepMm);
    constexpr double kPart = 0.1; // of a step: what a person can tell
    const int digits = std::clamp(int(std::ceil(-std::log10(kPart * stepMm / unit.mm))), 0, 6);
    return fmt::format("{:.{}f} {}", mm / unit.mm, digits, unit.name);
}

// With as many digits as an area has whose border is known to a tenth of a step.
std::string areaLabel(double mm2, double stepMm) {
    const Unit& unit = unitFor(stepMm);
    const double border = std::sqrt(mm2) * 4;
    const double known = std::max(0.1 * stepMm * border, 1e-300) / (unit.mm * unit.mm);
    const int digits = std::clamp(int(std::ceil(-std::log10(known))), 0, 6);
    return fmt::format("{:.{}f} {}²", mm2 / (unit.mm * unit.mm), digits, unit.name);
}

const char* unitOf(Measure::Kind kind) {
    switch (kind) {
    case Measure::Kind::Angle:
        return "degrees";
    case Measure::Kind::Area:
        return "mm2";
    case Measure::Kind::Cut:
        return "ml";
    case Measure::Kind::Distance:
    case Measure::Kind::Path:
    case Measure::Kind::Vessel:
        break;
    }
    return "mm";
}

// How far along its centreline each point is, and where it is narrow.
void followVessel(Measured& vessel) {
    segment::Vessel found;
    for (std::size_t n = 0; n < vessel.world.size(); ++n) {
        vessel.value += n == 0 ? 0 : glm::distance(vessel.world[n - 1], vessel.world[n]);
        vessel.alongMm.push_back(vessel.value);
        segment::VesselPoint point;
        point.alongMm = vessel.value;
        point.diameterMm = vessel.measure.diametersMm[n];
        found.points.push_back(point);
    }
    found.lengthMm = vessel.value;
    vessel.diametersMm = vessel.measure.diametersMm;
    vessel.narrowest = segment::narrowestOf(found);
}

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{:.10g}", value); }

} // namespace

Measured measured(const Measure& measure, const volume::Volume& volume) {
    Measured result;
    result.measure = measure;
    const bool isVessel = measure.kind == Measure::Kind::Vessel;
    for (const glm::dvec3& point : isVessel ? measure.centreline : measure.points) {
        result.world.emplace_back(volume.geometry.worldFromVoxel * glm::dvec4(point, 1));
    }
    switch (measure.kind) {
    case Measure::Kind::Distance:
    case Measure::Kind::Path:
        result.value = volume::lengthMm(result.world);
        break;
    case Measure::Kind::Angle:
        result.value = volume::angleDegrees(result.world[0], result.world[1], result.world[2]);
        break;
    case Measure::Kind::Area:
        result.under = volume::underOutline(volume, measure.points);
        result.value = result.under.mm2;
        break;
    case Measure::Kind::Vessel:
        followVessel(result);
        break;
    case Measure::Kind::Cut:
        result.value = measure.voxelsCut.value_or(0) * volume.geometry.voxelMm3() / 1000;
        break;
    }
    return result;
}

std::vector<Measured> allMeasured(std::span<const Measure> measures, const volume::Volume& volume,
                                  std::span<const Measured> known) {
    std::vector<Measured> found;
    for (std::size_t n = 0; n < measures.size(); ++n) {
        const bool isKnown = n < known.size() && known[n].measure == measures[n];
        found.push_back(isKnown ? known[n] : measured(measures[n], volume));
    }
    return found;
}

std::string labelOf(const Measured& measured, const volume::GridGeometry& geometry) {
    const double step = geometry.stepMm();
    switch (measured.measure.kind) {
    case Measure::Kind::Angle:
        return fmt::format("{:.1f}°", measured.value);
    case Measure::Kind::Area:
        return areaLabel(measured.value, step);
    case Measure::Kind::Cut:
        return fmt::format("{:.{}f} ml", measured.value,
                           std::clamp(int(std::ceil(-std::log10(geometry.voxelMm3() / 1000))), 0, 9));
    case Measure::Kind::Distance:
    case Measure::Kind::Path:
    case Measure::Kind::Vessel:
        break;
    }
    return lengthLabel(measured.value, step);
}

std::string lengthText(double mm, const volume::GridGeometry& geometry) {
    return lengthLabel(mm, geometry.stepMm());
}

std::string narrowestOf(const Measured& measured, const volume::GridGeometry& geometry) {
    if (!measured.isNarrowed()) {
        return {};
    }
    return fmt::format("⌀ {} (−{:.0f} %)", lengthText(measured.narrowest->diameterMm, geometry),
                       measured.narrowest->stenosisPercent);
}

std::string valuesOf(const Measured& measured) {
    const auto& under = measured.under;
    if (under.voxels == 0) {
        return {};
    }
    if (under.deviation <= 0) {
        return fmt::format("{:.6g} ± 0", under.mean);
    }
    // Three digits of the spread: the mean has no more behind the point.
    const int digits = std::clamp(2 - int(std::floor(std::log10(under.deviation))), 0, 9);
    return fmt::format("{:.{}f} ± {:.{}f}", under.mean, digits, under.deviation, digits);
}

std::string csvOf(std::span<const Measured> measurements) {
    std::string text =
        "number,kind,value,unit,voxels,mean,standard_deviation,minimum,maximum,narrowest_mm,reference_mm,"
        "stenosis_percent,points_lps_mm\n";
    for (std::size_t n = 0; n < measurements.size(); ++n) {
        const Measured& one = measurements[n];
        const auto& under = one.under;
        std::string points;
        for (const glm::dvec3& place : one.world) {
            points += fmt::format("{}{:.10g} {:.10g} {:.10g}", points.empty() ? "" : "; ", place.x, place.y,
                                  place.z);
        }
        const std::string narrow = one.narrowest ? fmt::format("{},{},{}", field(one.narrowest->diameterMm),
                                                               field(one.narrowest->referenceDiameterMm),
                                                               field(one.narrowest->stenosisPercent))
                                                 : ",,";
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{}\n", n, nameOf(one.measure.kind), field(one.value),
            unitOf(one.measure.kind), one.isArea() ? std::to_string(under.voxels) : "", field(under.mean),
            field(under.deviation), field(under.smallest), field(under.largest), narrow, points);
    }
    return text;
}

std::string vesselsCsvOf(std::span<const Measured> measurements) {
    std::string text = "number,segment,along_mm,diameter_mm,x_lps_mm,y_lps_mm,z_lps_mm\n";
    for (std::size_t n = 0; n < measurements.size(); ++n) {
        const Measured& one = measurements[n];
        for (std::size_t point = 0; one.isVessel() && point < one.world.size(); ++point) {
            const glm::dvec3& place = one.world[point];
            text += fmt::format("{},{},{},{},{},{},{}\n", n, csvField(one.measure.segment.value_or("")),
                                field(one.alongMm[point]), field(one.diametersMm[point]), field(place.x),
                                field(place.y), field(place.z));
        }
    }
    return text;
}

} // namespace vs::studio
