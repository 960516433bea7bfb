// SPDX-License-Identifier: Apache-2.0
#include "sculpt/radiation/footprint.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>

namespace vs::sculpt {

namespace {

// Below this variance (voxels^2) a quadratic B-spline, whose own is 1/4, is already wider than the Gaussian;
// the middle between its variance and the linear one's 1/6 decides.
constexpr double kQuadraticVariance = 5.0 / 24.0;

// Variances of Gaussians for which a cubic deposit (variance 1/3) is worth its 64 voxels a point instead
// of 27.
constexpr double kCubicFrom = 0.36;
constexpr double kCubicTo = 0.5;

double spline(int degree, double x) {
    x = std::abs(x);
    if (degree == 1) {
        return std::max(0.0, 1.0 - x);
    }
    if (degree == 3) {
        return x < 1 ? (3 * x * x * x - 6 * x * x + 4) / 6 : (x < 2 ? (2 - x) * (2 - x) * (2 - x) / 6 : 0);
    }
    return x < 0.5 ? 0.75 - x * x : (x < 1.5 ? 0.5 * (1.5 - x) * (1.5 - x) : 0.0);
}

// Gaussian elimination with pivoting of n equations, n <= kMaxReach; rows hold n coefficients and the right
// side.
using Rows = std::array<std::array<double, AxisFootprint::kMaxReach + 1>, AxisFootprint::kMaxReach>;
std::array<double, AxisFootprint::kMaxReach> solve(Rows rows, int n) {
    for (int column = 0; column < n; ++column) {
        int pivot = column;
        for (int row = column + 1; row < n; ++row) {
            pivot = std::abs(rows[row][column]) > std::abs(rows[pivot][column]) ? row : pivot;
        }
        std::swap(rows[column], rows[pivot]);
        for (int row = 0; row < n; ++row) {
            if (row != column) {
                const double factor = rows[row][column] / rows[column][column];
                for (int k = column; k < n; ++k) {
                    rows[row][k] -= factor * rows[column][k];
                }
                rows[row][AxisFootprint::kMaxReach] -= factor * rows[column][AxisFootprint::kMaxReach];
            }
        }
    }
    std::array<double, AxisFootprint::kMaxReach> solution{};
    for (int row = 0; row < n; ++row) {
        solution[row] = rows[row][AxisFootprint::kMaxReach] / rows[row][row];
    }
    return solution;
}

// Adds one residual sum_k t[k] basis[k] - target, with a weight, to the normal equations.
void addResidual(Rows& rows, const std::array<double, AxisFootprint::kMaxReach + 1>& residual, int reach,
                 double weight) {
    for (int row = 0; row < reach; ++row) {
        for (int column = 0; column < reach; ++column) {
            rows[row][column] += weight * residual[row] * residual[column];
        }
        rows[row][AxisFootprint::kMaxReach] += weight * residual[row] * residual[AxisFootprint::kMaxReach];
    }
}

// Least squares for t[1..reach], with t[0] = 1 - 2 sum(t), over all places p of a point relative to a voxel.
// A residual is spline(p) + sum_k t[k] (spline(p - k) + spline(p + k) - 2 spline(p)) - reference(p). Solids
// are sums of many points, so the residuals' running integral counts too: the error next to a straight edge.
std::array<double, AxisFootprint::kMaxReach> fitTaps(double sigma, int degree, int reach) {
    constexpr int kOffsets = 64;
    constexpr int kExtent = 8; // voxels on either side: beyond every support
    const double edgeWeight =
        sigma < 0.8 ? 30 : 0; // wider Gaussians have no trouble with edges; there peaks matter more
    Rows rows{};
    std::array<double, AxisFootprint::kMaxReach + 1> edge{};
    for (int cell = -kExtent; cell <= kExtent; ++cell) {
        for (int sample = 0; sample < kOffsets; ++sample) {
            const double u = (sample + 0.5) / kOffsets; // the point lies at cell + u, the voxel at 0
            const double p = cell + u;
            const ReferenceWeights wanted = referenceWeights(sigma, u);
            const int n = wanted.halfWidth - 1 - cell;
            const double middle = spline(degree, p);
            std::array<double, AxisFootprint::kMaxReach + 1> residual{};
            residual[AxisFootprint::kMaxReach] =
                (n >= 0 && n < 2 * wanted.halfWidth ? wanted.weights[n] : 0.0) - middle;
            for (int k = 1; k <= reach; ++k) {
                residual[k - 1] = spline(degree, p - k) + spline(degree, p + k) - 2 * middle;
            }
            for (std::size_t k = 0; k < edge.size(); ++k) {
                edge[k] += residual[k] / kOffsets;
            }
            addResidual(rows, residual, reach, 1);
            addResidual(rows, edge, reach, edgeWeight);
        }
    }
    return solve(rows, reach);
}

AxisFootprint fitAxis(double sigma, bool isSmoothWhereCoarse) {
    AxisFootprint axis;
    if (sigma * sigma < kQuadraticVariance) {
        axis.degree = isSmoothWhereCoarse ? 2 : 1;
        return axis;
    }
    // Around radius 2 a quadratic deposit leaves errors of 8e-3 where edges meet, a cubic one half of that.
    axis.degree = sigma * sigma > kCubicFrom && sigma * sigma < kCubicTo ? 3 : 2;
    // The deposit itself reaches 1.5 voxels, so one tap fewer than the Gaussian's 3 sigma covers it. The
    // narrowest needs its second tap all the same, slightly negative: it sharpens what the deposit has
    // blurred.
    axis.reach = std::clamp(int(std::ceil(3 * sigma - 1e-6)) - 1, 2, AxisFootprint::kMaxReach);
    const auto taps = fitTaps(sigma, axis.degree, axis.reach);
    float sides = 0;
    for (int k = 1; k <= axis.reach; ++k) {
        axis.taps[k] = float(taps[k - 1]);
        sides += 2 * axis.taps[k];
    }
    axis.taps[0] = 1.0F - sides;
    return axis;
}

// How much of voxel k's cell a box of this half-width around voxel 0 covers, of the whole box.
double cubeShare(double halfWidth, int k) {
    return std::max(0.0, std::min(k + 0.5, halfWidth) - std::max(k - 0.5, -halfWidth)) / (2 * halfWidth);
}

AxisFootprint cubeAxis(double halfWidth) {
    AxisFootprint axis;
    axis.degree = 1;
    axis.reach = int(std::ceil(halfWidth - 0.5 - 1e-6));
    for (int k = 0; k <= axis.reach; ++k) {
        axis.taps[std::size_t(k)] = float(cubeShare(halfWidth, k));
    }
    return axis;
}

} // namespace

glm::ivec3 Footprint::reachVoxels() const {
    const auto reach = [](const AxisFootprint& axis) { return axis.reach + (axis.degree == 3 ? 2 : 1); };
    return {reach(axes[0]), reach(axes[1]), reach(axes[2])};
}

ReferenceWeights referenceWeights(double sigma, double offset) {
    ReferenceWeights out;
    out.halfWidth = std::clamp(int(std::ceil(3 * sigma - 1e-6)), 1, 4);
    double sum = 0;
    for (int n = 0; n < 2 * out.halfWidth; ++n) {
        const double x = n + 1 - out.halfWidth - offset;
        out.weights[n] = std::exp(-0.5 * x * x / (sigma * sigma));
        sum += out.weights[n];
    }
    for (double& weight : out.weights) {
        weight /= sum;
    }
    return out;
}

ReferenceWeights cubeReferenceWeights(double halfWidthVoxels, double offset) {
    ReferenceWeights out;
    out.halfWidth = int(out.weights.size()) / 2;
    for (int n = 0; n < 2 * out.halfWidth; ++n) {
        const int voxel = n + 1 - out.halfWidth;
        out.weights[std::size_t(n)] =
            (1 - offset) * cubeShare(halfWidthVoxels, voxel) + offset * cubeShare(halfWidthVoxels, voxel - 1);
    }
    return out;
}

Footprint fitFootprint(const FootprintShape& shape, glm::dvec3 spacing) {
    VS_CHECK(shape.kind == FootprintKind::Ellipsoid || (shape.radius >= 2 && shape.radius <= 4));
    const double step = std::min({spacing.x, spacing.y, spacing.z});
    Footprint footprint;
    footprint.radius = shape.radius;
    for (int axis = 0; axis < 3; ++axis) {
        const double voxels = step / spacing[axis]; // per step
        if (shape.kind == FootprintKind::Cube) {
            footprint.axes[std::size_t(axis)] = cubeAxis(shape.radius * voxels);
            footprint.sigmaVoxels[axis] = shape.radius * voxels / std::sqrt(3.0);
            continue;
        }
        const double sigma =
            shape.kind == FootprintKind::Ellipsoid ? shape.sigmaSteps[axis] : shape.radius / 3.0;
        VS_CHECK(sigma > 0 && sigma <= FootprintShape::kMaxSigmaVoxels + 1e-9);
        footprint.sigmaVoxels[axis] = sigma * voxels;
        footprint.axes[std::size_t(axis)] = fitAxis(footprint.sigmaVoxels[axis], shape.isSmoothWhereCoarse);
    }
    return footprint;
}

Footprint fitFootprint(int radius, glm::dvec3 spacing) {
    FootprintShape shape;
    shape.radius = radius;
    return fitFootprint(shape, spacing);
}

} // namespace vs::sculpt
