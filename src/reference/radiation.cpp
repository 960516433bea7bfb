// SPDX-License-Identifier: Apache-2.0
#include "reference/radiation.h"

#include <array>
#include <cmath>

namespace vs::reference {

namespace {

struct Weights {
    int first = 0;
    int count = 0;
    std::array<double, 16> values{};
};

Weights weightsAlong(double position, double sigma) {
    const int halfWidth = std::max(1, int(std::ceil(3 * sigma - 1e-6)));
    Weights out;
    out.first = int(std::floor(position)) - halfWidth + 1;
    out.count = 2 * halfWidth;
    double sum = 0;
    for (int n = 0; n < out.count; ++n) {
        const double x = (out.first + n - position) / sigma;
        out.values[std::size_t(n)] = std::exp(-0.5 * x * x);
        sum += out.values[std::size_t(n)];
    }
    for (double& value : out.values) {
        value /= sum;
    }
    return out;
}

} // namespace

std::vector<float> radiate(std::span<const glm::vec4> points, glm::ivec3 dims, glm::dvec3 sigmaVoxels) {
    std::vector<double> sum(Box3{glm::ivec3(0), dims}.volume(), 0.0);
    for (const glm::vec4& point : points) {
        const Weights x = weightsAlong(point.x, sigmaVoxels.x);
        const Weights y = weightsAlong(point.y, sigmaVoxels.y);
        const Weights z = weightsAlong(point.z, sigmaVoxels.z);
        for (int k = std::max(0, -z.first); k < std::min(z.count, dims.z - z.first); ++k) {
            for (int j = std::max(0, -y.first); j < std::min(y.count, dims.y - y.first); ++j) {
                const double plane = double(point.w) * z.values[std::size_t(k)] * y.values[std::size_t(j)];
                const std::size_t row =
                    (std::size_t(z.first + k) * std::size_t(dims.y) + std::size_t(y.first + j)) *
                    std::size_t(dims.x);
                for (int i = std::max(0, -x.first); i < std::min(x.count, dims.x - x.first); ++i) {
                    sum[row + std::size_t(x.first + i)] += plane * x.values[std::size_t(i)];
                }
            }
        }
    }
    return {sum.begin(), sum.end()};
}

} // namespace vs::reference
