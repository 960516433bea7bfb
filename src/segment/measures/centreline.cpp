// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/centreline.h"

#include "base/progress.h"
#include "base/statistics.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

constexpr int kRounds = 4; // of moving the axis into the middle; the second leaves less than half a voxel

glm::dvec3 worldOf(const Lumen& lumen, glm::ivec3 voxel) {
    return glm::dvec3(lumen.worldFromVoxel * glm::dvec4(glm::dvec3(voxel), 1));
}

// How far rays are to go from a point on or near the axis: a vessel that is twice as wide as thick is still
// seen whole.
double reachMm(const Lumen& lumen, double radiusMm) { return 3 * radiusMm + 2 * lumen.coarseMm; }

// Moves a station into the middle of what it sees; returns how wide it is there.
double moveIntoMiddle(const Lumen& lumen, Station& station, double radiusMm) {
    const Outline outline = outlineAround(lumen, station, reachMm(lumen, radiusMm));
    if (outline.typicalMm <= 0) {
        return radiusMm; // it lies outside: the curve cuts a corner
    }
    const double far = glm::length(outline.middleMm);
    const glm::dvec2 shift = outline.middleMm * std::min(1.0, radiusMm / std::max(far, 1e-9));
    station.place += shift.x * station.across + shift.y * station.up;
    return outline.typicalMm;
}

std::vector<glm::dvec3> placesOf(const Curve& curve) {
    std::vector<glm::dvec3> places;
    places.reserve(curve.size());
    for (const Station& station : curve) {
        places.push_back(station.place);
    }
    return places;
}

// The values at the stations of a curve, for one that has other stations in the same stretch.
std::vector<double> carriedOver(const std::vector<double>& values, std::size_t count) {
    std::vector<double> carried;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t last = std::max<std::size_t>(1, count - 1);
        carried.push_back(values[i * (values.size() - 1) / last]);
    }
    return carried;
}

void settle(const Lumen& lumen, Centreline& line) {
    for (int round = 0; round < kRounds; ++round) {
        reportProgress();
        for (std::size_t i = 0; i < line.curve.size(); ++i) {
            line.radiiMm[i] = moveIntoMiddle(lumen, line.curve[i], line.radiiMm[i]);
        }
        line.curve = smoothCurve(placesOf(line.curve), smoothingMm(lumen, line.radiiMm),
                                 spacingMm(lumen, median(line.radiiMm)));
        line.radiiMm = carriedOver(line.radiiMm, line.curve.size());
    }
}

// How many voxels of a path lie before it is in the middle: as far from its end as it may be from the axis
// there. A path that comes from the wall has little clearance at first.
std::size_t beforeMiddle(const Lumen& lumen, const VesselPath& path, bool isFromBack) {
    const std::size_t count = path.voxels.size();
    const auto at = [&](std::size_t i) { return isFromBack ? count - 1 - i : i; };
    const glm::dvec3 end = worldOf(lumen, path.voxels[at(0)]);
    double widest = median(path.clearanceMm);
    for (std::size_t i = 0; i < count; ++i) {
        widest = std::max(widest, path.clearanceMm[at(i)]);
        if (glm::distance(worldOf(lumen, path.voxels[at(i)]), end) > 1.5 * widest) {
            return i;
        }
    }
    return count;
}

// The part of the path that runs in the middle; nothing where that is too short to show a direction.
Centreline middlePart(const Lumen& lumen, const VesselPath& path) {
    const double radius = median(path.clearanceMm);
    const std::size_t first = beforeMiddle(lumen, path, false);
    const std::size_t after = path.voxels.size() - beforeMiddle(lumen, path, true);
    std::vector<glm::dvec3> places;
    for (std::size_t i = first; i < after; ++i) {
        places.push_back(worldOf(lumen, path.voxels[i]));
    }
    if (places.size() < 2 || glm::distance(places.front(), places.back()) < 2 * radius) {
        return {};
    }
    Centreline line{smoothCurve(places, std::max(2 * lumen.coarseMm, 0.5 * radius), spacingMm(lumen, radius)),
                    {}};
    const auto clearance = path.clearanceMm.begin();
    line.radiiMm = carriedOver({clearance + std::ptrdiff_t(first), clearance + std::ptrdiff_t(after)},
                               line.curve.size());
    return line;
}

// The least cosine of the angle between a vessel and a path in it, from wall to opposite wall at most, as
// long as `lengthMm`. Radii are known by half a voxel, and vessels bend.
double leastCosineOfPath(double lengthMm, double radiusMm) {
    const double across = std::min(1.0, 2.4 * radiusMm / std::max(lengthMm, 1e-9));
    return std::max(0.0, std::sqrt(1 - across * across) - 0.1);
}

// The direction in which a vessel looks narrowest from a place on its axis is its own.
Station narrowestAcross(const Lumen& lumen, const glm::dvec3& place, double radiusMm,
                        const glm::dvec3& pathMm) {
    const double length = glm::length(pathMm);
    const double leastCosine = leastCosineOfPath(length, radiusMm);
    constexpr int kDirections = 200; // about 10 degrees apart on the half sphere
    Station best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kDirections; ++i) {
        // On a spiral from the pole to the equator, each turn by the golden angle.
        const double z = (i + 0.5) / kDirections;
        const double angle = i * glm::pi<double>() * (3 - std::sqrt(5.0));
        const double r = std::sqrt(1 - z * z);
        const glm::dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
        if (std::abs(glm::dot(direction, pathMm)) < leastCosine * length) {
            continue;
        }
        const Station station = stationAcross(place, direction, glm::dvec3(0));
        const Outline outline = outlineAround(lumen, station, reachMm(lumen, radiusMm));
        double area = 0;
        for (const double radius : outline.radiiMm) {
            area += radius * radius;
        }
        if (area < least) {
            least = area;
            best = station;
        }
    }
    return best;
}

// A short piece of the axis for a path that is too short to show a direction: through the middle at its
// widest voxel.
Centreline shortPart(const Lumen& lumen, const VesselPath& path) {
    const auto widest = std::max_element(path.clearanceMm.begin(), path.clearanceMm.end());
    double radius = *widest;
    Station station;
    station.place = worldOf(lumen, path.voxels[std::size_t(widest - path.clearanceMm.begin())]);
    const glm::dvec3 way = worldOf(lumen, path.voxels.back()) - worldOf(lumen, path.voxels.front());
    for (int round = 0; round < 3; ++round) {
        station = narrowestAcross(lumen, station.place, radius, way);
        radius = moveIntoMiddle(lumen, station, radius);
    }
    const glm::dvec3 along = (glm::dot(way, station.tangent) < 0 ? -1.0 : 1.0) * station.tangent;
    const double half = 0.5 * spacingMm(lumen, radius);
    const std::vector<glm::dvec3> places{station.place - half * along, station.place + half * along};
    return {smoothCurve(places, lumen.coarseMm, 4 * half), {radius, radius}};
}

// The way that a row of places goes on at its end, told by about as much of it as it is wide.
glm::dvec3 wayAtEnd(const std::vector<glm::dvec3>& places, double lookBackMm) {
    std::size_t i = places.size() - 1;
    while (i > 0 && glm::distance(places[i], places.back()) < lookBackMm) {
        --i;
    }
    return glm::normalize(places.back() - places[i]);
}

// Goes on at the curve's end, always into the middle, until the plane through `end` lies well behind, or the
// vessel ends: before its very end, since a plane there that is a little tilted sees one side only, moves its
// station there, and tilts the more.
void goOn(const Lumen& lumen, std::vector<glm::dvec3>& places, std::vector<double>& radii,
          const glm::dvec3& end) {
    const double step = spacingMm(lumen, radii.back());
    const double margin = 1.5 * radii.back() + 3 * lumen.coarseMm;
    const double most = 4 * (glm::distance(places.back(), end) + margin);
    for (double gone = 0; gone < most; gone += step) {
        const glm::dvec3 way = wayAtEnd(places, std::max(1.5 * radii.back(), 2 * lumen.coarseMm));
        if (glm::dot(places.back() - end, way) > margin) {
            return;
        }
        Station next = stationAcross(places.back() + step * way, way, glm::dvec3(0));
        if (wallMm(lumen, next.place, way, 0.7 * radii.back()) < 0.7 * radii.back()) {
            return;
        }
        const glm::dvec3 straight = next.place;
        const double radius = moveIntoMiddle(lumen, next, radii.back());
        // The end of a vessel, or the room where it branches, pulls sideways: it may bend, not leap.
        const glm::dvec3 shift = next.place - straight;
        const double far = glm::length(shift);
        places.push_back(straight + shift * std::min(1.0, 0.3 * step / std::max(far, 1e-9)));
        radii.push_back(radius);
    }
}

} // namespace

double spacingMm(const Lumen& lumen, double radiusMm) { return std::max(lumen.stepMm, radiusMm / 6); }

double smoothingMm(const Lumen& lumen, const std::vector<double>& radiiMm) {
    return std::max(1.5 * lumen.coarseMm, 0.5 * median(radiiMm));
}

Centreline centrelineAlong(const Lumen& lumen, const VesselPath& path) {
    Centreline line = middlePart(lumen, path);
    if (line.curve.empty()) {
        line = shortPart(lumen, path);
    } else {
        settle(lumen, line);
    }
    std::vector<glm::dvec3> places = placesOf(line.curve);
    for (const glm::ivec3 end : {path.voxels.back(), path.voxels.front()}) {
        goOn(lumen, places, line.radiiMm, worldOf(lumen, end));
        std::reverse(places.begin(), places.end());
        std::reverse(line.radiiMm.begin(), line.radiiMm.end());
    }
    line.curve =
        smoothCurve(places, smoothingMm(lumen, line.radiiMm), spacingMm(lumen, median(line.radiiMm)));
    line.radiiMm = carriedOver(line.radiiMm, line.curve.size());
    settle(lumen, line);
    return line;
}

} // namespace vs::segment
