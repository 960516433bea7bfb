// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/phrase.h"
#include "studio/operations/description.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

inline constexpr int kMostMeasurements = 1000;

// Puts something that is measured on the document's list: it is drawn on slices and pictures, and says what
// it comes to by what the scan is now. Points are in voxel space, so that they stay on what they were put on
// when the scan's geometry is corrected.
struct Measure {
    static constexpr About kAbout{
        VS_TEXT("library", "measure"), Effect::Measures,
        "measures a distance between two points of the scan, an angle at the second of three, the length of "
        "a path, the area inside an outline on a slice with the values in it, a vessel between two places "
        "along it (its centreline, its diameters, the narrowest of them), or how much is cut away",
        "measure"};
    enum class Kind { Distance, Angle, Path, Area, Vessel, Cut };
    static constexpr std::array<const char*, 6> kKinds{
        VS_TEXT("library", "distance"), VS_TEXT("library", "angle"),  VS_TEXT("library", "path"),
        VS_TEXT("library", "area"),     VS_TEXT("library", "vessel"), VS_TEXT("library", "cut")};

    Kind kind = Kind::Distance;
    std::vector<glm::dvec3> points = {};
    std::optional<double> voxelsCut = {}; // when a cut was measured
    // A vessel has these: the segment that it is (without: the one at the first point, else the one at work),
    // and what was found then, since segments change: points of its centreline, and the diameter at each.
    std::optional<std::string> segment = {};
    std::vector<glm::dvec3> centreline = {};
    std::vector<double> diametersMm = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{
            required("kind", &Measure::kind),
            written("points", &Measure::points,
                    {.least = -1e5, .most = 1e5, .unit = "voxels", .mostCount = 100000},
                    "two, or three of an angle; of a path at least two; of an area at least three that lie "
                    "in one slice; of a vessel two on it; of a cut none"),
            sparse("voxelsCut", &Measure::voxelsCut, {.least = 0, .most = 1e15, .unit = "voxels"},
                   "of a cut: what was found"),
            sparse("segment", &Measure::segment, {.leastCount = 1, .mostCount = 200, .isReference = true},
                   "that the vessel is; without: the one at its first point, else the one at work"),
            sparse("centreline", &Measure::centreline,
                   {.least = -1e5, .most = 1e5, .unit = "voxels", .mostCount = 100000},
                   "of a vessel: what was found"),
            sparse("diameters", &Measure::diametersMm,
                   {.least = 0, .most = 1e6, .unit = "mm", .mostCount = 100000},
                   "of a vessel, at the points of its centreline: what was found")};
    }
    [[nodiscard]] Fault faultOf() const;
    [[nodiscard]] std::vector<Phrase> details() const;
    bool operator==(const Measure&) const = default;
};
constexpr const auto& namesOf(Measure::Kind) { return Measure::kKinds; }

// Takes one measurement off the list, or all of them.
struct RemoveMeasurement {
    static constexpr About kAbout{
        VS_TEXT("library", "remove measurement"), Effect::Measures,
        "takes measurement number `measurement`, counted from 0, off the list; without a number all of them",
        "measure"};

    std::optional<int> measurement = {};

    template <typename = void>
    static constexpr auto fields() {
        return std::tuple{sparse("measurement", &RemoveMeasurement::measurement,
                                 {.least = 0, .most = kMostMeasurements - 1})};
    }
    [[nodiscard]] std::vector<Phrase> details() const;
};

using MeasuringOperations = std::variant<Measure, RemoveMeasurement>;

} // namespace vs::studio
