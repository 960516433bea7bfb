// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/patch_surface.h"

#include "base/error.h"
#include "sculpt/surface/thin_plate.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

constexpr double kFarOff = 0.5;     // of the width: places farther from the plane belong to something else
constexpr int kMostCells = 128;     // along a side
constexpr double kSmoothing = 0.12; // of the width, over which roughness is smoothed away; at least two cells
constexpr std::size_t kFewest = 12; // places
constexpr int kSides = 12;
constexpr int kFewestSides = 11;

using Six = Eigen::Matrix<double, 6, 1>;

Six termsAt(glm::dvec2 p) {
    Six terms;
    terms << 1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y;
    return terms;
}

// On how many sides there are some of the places.
int sidesOf(std::span<const glm::dvec3> places) {
    std::array<bool, kSides> isSeen{};
    for (const glm::dvec3& p : places) {
        const double turn = (std::atan2(p.y, p.x) + glm::pi<double>()) / (2 * glm::pi<double>());
        isSeen[std::min(std::size_t(turn * kSides), std::size_t(kSides - 1))] = true;
    }
    return int(std::count(isSeen.begin(), isSeen.end(), true));
}

} // namespace

PatchSurface::PatchSurface(std::span<const glm::dvec3> around, const glm::dvec3& outward, double cellMm) {
    const auto fail = [] {
        throw Error("outline: a surface must be seen on all sides of the hole: draw the outline on it");
    };
    std::vector<glm::dvec3> places(around.begin(), around.end());
    for (int turn = 0; turn < 3; ++turn) {
        if (places.size() < kFewest) {
            fail();
        }
        findPlane(places, outward);
        std::erase_if(places, [this](const glm::dvec3& place) {
            return std::abs(inPlane(place).z) > kFarOff * widthMm_;
        });
    }
    std::transform(places.begin(), places.end(), places.begin(),
                   [this](const glm::dvec3& place) { return inPlane(place); });
    if (places.size() < kFewest || sidesOf(places) < kFewestSides) {
        fail();
    }
    const std::vector<double> counting = fitQuadric(places);
    glm::dvec2 lo(1e300);
    glm::dvec2 hi(-1e300);
    for (const glm::dvec3& place : places) {
        lo = glm::min(lo, glm::dvec2(place));
        hi = glm::max(hi, glm::dvec2(place));
    }
    cellMm_ = std::max(cellMm, std::max(hi.x - lo.x, hi.y - lo.y) / kMostCells);
    constexpr int margin = 2; // cells
    size_ = glm::ivec2(glm::ceil((hi - lo) / cellMm_)) + 1 + 2 * margin;
    first_ = lo - double(margin) * cellMm_;
    PlateRaster known;
    known.size = size_;
    known.heights.assign(std::size_t(size_.x) * std::size_t(size_.y), 0.0);
    known.weights = known.heights;
    std::vector<int> counts(known.heights.size(), 0);
    for (std::size_t n = 0; n < places.size(); ++n) {
        const glm::ivec2 cell(glm::round((glm::dvec2(places[n]) - first_) / cellMm_));
        const std::size_t i = std::size_t(cell.y) * std::size_t(size_.x) + std::size_t(cell.x);
        known.heights[i] += counting[n] * (places[n].z - quadricAt(places[n]));
        known.weights[i] += counting[n];
        ++counts[i];
    }
    const double weight = std::pow(std::max(kSmoothing * widthMm_ / cellMm_, 2.0), -4.0);
    for (std::size_t i = 0; i < known.heights.size(); ++i) {
        known.heights[i] /= std::max(known.weights[i], 1e-9);
        known.weights[i] *= weight / std::max(counts[i], 1);
    }
    heights_ = thinPlate(known);
}

// Least squares in which places count less, the farther they are off (Cauchy's weights).
std::vector<double> PatchSurface::fitQuadric(std::span<const glm::dvec3> inPlane) {
    constexpr int turns = 8;
    const double half = 0.5 * widthMm_;
    std::vector<double> off(inPlane.size(), 0.0);
    double usual = 1e300; // how far places are off
    for (int turn = 0; turn < turns; ++turn) {
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
        Six wanted = Six::Zero();
        for (std::size_t n = 0; n < inPlane.size(); ++n) {
            const double far = off[n] / usual;
            const double weight = 1 / (1 + far * far);
            const Six terms = termsAt(glm::dvec2(inPlane[n]) / half);
            normal += weight * terms * terms.transpose();
            wanted += weight * inPlane[n].z * terms;
        }
        const Six found = normal.ldlt().solve(wanted);
        std::copy(found.data(), found.data() + found.size(), quadric_.begin());
        std::vector<double> sorted;
        for (std::size_t n = 0; n < inPlane.size(); ++n) {
            off[n] = inPlane[n].z - quadricAt(inPlane[n]);
            sorted.push_back(std::abs(off[n]));
        }
        const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        usual = std::max(2 * *middle, 1e-3 * half);
    }
    std::transform(off.begin(), off.end(), off.begin(),
                   [usual](double far) { return 1 / (1 + far / usual * (far / usual)); });
    return off;
}

double PatchSurface::quadricAt(glm::dvec2 place) const {
    const Six terms = termsAt(place / (0.5 * widthMm_));
    double height = 0;
    for (int i = 0; i < 6; ++i) {
        height += quadric_[std::size_t(i)] * terms[i];
    }
    return height;
}

// The plane from which the places differ least, its normal on the side of `outward`.
void PatchSurface::findPlane(std::span<const glm::dvec3> around, const glm::dvec3& outward) {
    origin_ = glm::dvec3(0);
    for (const glm::dvec3& place : around) {
        origin_ += place / double(around.size());
    }
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const glm::dvec3& place : around) {
        const Eigen::Vector3d d(place.x - origin_.x, place.y - origin_.y, place.z - origin_.z);
        scatter += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter); // the least first
    const auto axis = [&](int n) {
        const Eigen::Vector3d v = solver.eigenvectors().col(n);
        return glm::dvec3(v.x(), v.y(), v.z());
    };
    const glm::dvec3 normal = glm::dot(axis(0), outward) < 0 ? -axis(0) : axis(0);
    axes_ = glm::dmat3(axis(2), glm::cross(normal, axis(2)), normal);
    // Of places evenly about a circle the mean square along an axis is an eighth of the width's square.
    widthMm_ = std::sqrt(8 * solver.eigenvalues()[2] / double(around.size()));
}

glm::dvec3 PatchSurface::inPlane(const glm::dvec3& place) const {
    return glm::transpose(axes_) * (place - origin_);
}

double PatchSurface::at(int x, int y) const {
    const glm::ivec2 cell = glm::clamp(glm::ivec2(x, y), glm::ivec2(0), size_ - 1);
    return heights_[std::size_t(cell.y) * std::size_t(size_.x) + std::size_t(cell.x)];
}

double PatchSurface::depthOf(const glm::dvec3& place) const {
    const glm::dvec3 p = inPlane(place);
    const glm::dvec2 cells =
        glm::clamp((glm::dvec2(p) - first_) / cellMm_, glm::dvec2(0), glm::dvec2(size_ - 1));
    const glm::ivec2 first(glm::floor(cells));
    const glm::dvec2 part = cells - glm::dvec2(first);
    const double a = glm::mix(at(first.x, first.y), at(first.x + 1, first.y), part.x);
    const double b = glm::mix(at(first.x, first.y + 1), at(first.x + 1, first.y + 1), part.x);
    const glm::dvec2 within = first_ + cells * cellMm_;
    const double height = quadricAt(within) + glm::mix(a, b, part.y);
    const glm::ivec2 near(glm::round(cells));
    const glm::dvec2 slope(at(near.x + 1, near.y) - at(near.x - 1, near.y),
                           at(near.x, near.y + 1) - at(near.x, near.y - 1));
    const glm::dvec2 along(cellMm_, 0);
    const glm::dvec2 across(0, cellMm_);
    const glm::dvec2 ofQuadric(quadricAt(within + along) - quadricAt(within - along),
                               quadricAt(within + across) - quadricAt(within - across));
    const glm::dvec2 perMm = (slope + ofQuadric) / (2 * cellMm_);
    return (height - p.z) / std::sqrt(1 + glm::dot(perMm, perMm));
}

} // namespace vs::sculpt
