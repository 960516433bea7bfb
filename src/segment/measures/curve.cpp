// SPDX-License-Identifier: Apache-2.0
#include "segment/measures/curve.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vs::segment {
namespace {

std::vector<double> lengthsUpTo(std::span<const glm::dvec3> places) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < places.size(); ++i) {
        along.push_back(along.back() + glm::distance(places[i - 1], places[i]));
    }
    return along;
}

// Where a curve is at one point, and which way it goes there.
struct PlaceAndWay {
    glm::dvec3 place, way;
};

// Fits place + way s + bend s^2 to places, s the length from `at`.
PlaceAndWay fittedAt(double at, std::span<const glm::dvec3> places, std::span<const double> along,
                     double sigma) {
    glm::dmat3 normal(0);
    glm::dmat3 right(0); // a column a power of s
    const auto first = std::lower_bound(along.begin(), along.end(), at - 3 * sigma);
    for (auto i = std::size_t(first - along.begin()); i < along.size() && along[i] <= at + 3 * sigma; ++i) {
        const double s = (along[i] - at) / sigma;
        const glm::dvec3 powers(1, s, s * s);
        const double weight = std::exp(-0.5 * s * s);
        normal += weight * glm::outerProduct(powers, powers);
        right += weight * glm::outerProduct(places[i], powers);
    }
    // Where there are too few places for a parabola, the curve is as straight as can be.
    const double weak = 1e-9 * normal[0][0];
    normal += glm::dmat3(0, 0, 0, 0, weak, 0, 0, 0, 100 * weak);
    const glm::dmat3 solved = right * glm::inverse(normal);
    return {solved[0], solved[1]};
}

glm::dvec3 anyAcross(const glm::dvec3& tangent) {
    const glm::dvec3 size = glm::abs(tangent);
    const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    glm::dvec3 axis(0);
    axis[least] = 1;
    return axis;
}

} // namespace

Station stationAcross(const glm::dvec3& place, const glm::dvec3& tangent, const glm::dvec3& across) {
    Station station{place, tangent};
    const glm::dvec3 flat = across - glm::dot(across, tangent) * tangent;
    station.across = glm::dot(flat, flat) > 1e-12 ? glm::normalize(flat)
                                                  : stationAcross(place, tangent, anyAcross(tangent)).across;
    station.up = glm::cross(tangent, station.across);
    return station;
}

Curve smoothCurve(std::span<const glm::dvec3> places, double sigmaMm, double spacingMm) {
    VS_CHECK(places.size() >= 2);
    const std::vector<double> along = lengthsUpTo(places);
    const int steps = std::max(1, int(std::ceil(along.back() / spacingMm - 1e-6)));
    Curve curve;
    glm::dvec3 tangent = places.back() - places.front();
    glm::dvec3 across(0);
    for (int i = 0; i <= steps; ++i) {
        const auto fitted = fittedAt(along.back() * i / steps, places, along, sigmaMm);
        tangent = glm::length(fitted.way) > 0 ? glm::normalize(fitted.way) : glm::normalize(tangent);
        Station station = stationAcross(fitted.place, tangent, across);
        across = station.across;
        if (!curve.empty()) {
            station.alongMm = curve.back().alongMm + glm::distance(curve.back().place, station.place);
        }
        curve.push_back(station);
    }
    return curve;
}

double alongNearest(const Curve& curve, const glm::dvec3& place) {
    // Where a plane goes through, from one station to the next, and how far that is.
    double best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const double before = glm::dot(place - curve[i].place, curve[i].tangent);
        const double after = glm::dot(place - curve[i + 1].place, curve[i + 1].tangent);
        const bool isFirst = i == 0 && before < 0;
        const bool isLast = i + 2 == curve.size() && after > 0;
        if ((before < 0 || after > 0) && !isFirst && !isLast) {
            continue;
        }
        const double part = before - after > 0 ? before / (before - after) : 0;
        const double along = isFirst  ? before
                             : isLast ? curve.back().alongMm + after
                                      : glm::mix(curve[i].alongMm, curve[i + 1].alongMm, part);
        const double distance = glm::distance(stationAt(curve, along).place, place);
        if (distance < least) {
            least = distance;
            best = along;
        }
    }
    return best;
}

Between between(const Curve& curve, double alongMm) {
    const auto next = std::upper_bound(curve.begin() + 1, curve.end() - 1, alongMm,
                                       [](double along, const Station& s) { return along < s.alongMm; });
    const auto before = next - 1;
    const double gap = next->alongMm - before->alongMm;
    const double part = gap > 0 ? (alongMm - before->alongMm) / gap : 0;
    return {std::size_t(before - curve.begin()), std::clamp(part, 0.0, 1.0)};
}

Station stationAt(const Curve& curve, double alongMm) {
    Station station;
    if (alongMm <= 0 || alongMm >= curve.back().alongMm) {
        station = alongMm <= 0 ? curve.front() : curve.back();
        station.place += (alongMm - station.alongMm) * station.tangent;
    } else {
        const Between at = between(curve, alongMm);
        const Station& a = curve[at.before];
        const Station& b = curve[at.before + 1];
        // A cubic with the stations' places and tangents.
        const double gap = b.alongMm - a.alongMm;
        const double t = at.part;
        const glm::dvec3 place = a.place * ((1 + 2 * t) * (1 - t) * (1 - t)) +
                                 b.place * (t * t * (3 - 2 * t)) +
                                 gap * (a.tangent * (t * (1 - t) * (1 - t)) - b.tangent * (t * t * (1 - t)));
        station = stationAcross(place, glm::normalize(glm::mix(a.tangent, b.tangent, t)), a.across);
    }
    station.alongMm = alongMm;
    return station;
}

} // namespace vs::segment
