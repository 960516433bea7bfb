// SPDX-License-Identifier: Apache-2.0
#include "sculpt/surface/thin_plate.h"

#include "base/check.h"
#include "base/error.h"

#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace vs::sculpt {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Cell = std::pair<int, double>; // number and factor

// Adds the square of a sum of cells times factors, times `weight`, to an energy.
void addSquare(std::vector<Eigen::Triplet<double>>& energy, std::initializer_list<Cell> sum, double weight) {
    for (const Cell& one : sum) {
        for (const Cell& other : sum) {
            energy.emplace_back(one.first, other.first, weight * one.second * other.second);
        }
    }
}

bool isDetermined(const PlateRaster& known) {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < known.size.y; ++y) {
        for (int x = 0; x < known.size.x; ++x) {
            if (known.weights[std::size_t(y) * std::size_t(known.size.x) + std::size_t(x)] > 0) {
                places.emplace_back(x, y);
            }
        }
    }
    if (places.size() < 3) {
        return false;
    }
    glm::dvec2 mean(0);
    for (const glm::dvec2 place : places) {
        mean += place / double(places.size());
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const glm::dvec2 place : places) {
        const glm::dvec2 d = place - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    return xx * yy - xy * xy > 1e-9 * (xx + yy) * (xx + yy);
}

} // namespace

std::vector<double> thinPlate(const PlateRaster& known) {
    const glm::ivec2 n = known.size;
    const int count = n.x * n.y;
    VS_CHECK_EQ(known.heights.size(), std::size_t(count));
    VS_CHECK_EQ(known.weights.size(), std::size_t(count));
    if (!isDetermined(known)) {
        throw Error("too little is known of the surface for a plate through it");
    }
    const auto at = [&](int x, int y) { return y * n.x + x; };
    std::vector<Eigen::Triplet<double>> energy;
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(count);
    for (int y = 0; y < n.y; ++y) {
        for (int x = 0; x < n.x; ++x) {
            if (x > 0 && x + 1 < n.x) {
                addSquare(energy, {{at(x - 1, y), 1}, {at(x, y), -2}, {at(x + 1, y), 1}}, 1);
            }
            if (y > 0 && y + 1 < n.y) {
                addSquare(energy, {{at(x, y - 1), 1}, {at(x, y), -2}, {at(x, y + 1), 1}}, 1);
            }
            if (x + 1 < n.x && y + 1 < n.y) {
                addSquare(energy,
                          {{at(x, y), 1}, {at(x + 1, y), -1}, {at(x, y + 1), -1}, {at(x + 1, y + 1), 1}}, 2);
            }
            const auto cell = std::size_t(at(x, y));
            addSquare(energy, {{int(cell), 1}}, known.weights[cell]);
            wanted[Eigen::Index(cell)] = known.weights[cell] * known.heights[cell];
        }
    }
    Matrix matrix(count, count);
    matrix.setFromTriplets(energy.begin(), energy.end());
    const Eigen::SimplicialLDLT<Matrix> factors(matrix);
    const Eigen::VectorXd heights = factors.solve(wanted);
    if (factors.info() != Eigen::Success || !heights.allFinite()) {
        throw Error("too little is known of the surface for a plate through it");
    }
    return {heights.data(), heights.data() + count};
}

} // namespace vs::sculpt
