// SPDX-License-Identifier: Apache-2.0
#include "sculpt/mask/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vs::sculpt {

namespace {

// The filter at x in [-1, 1] of its support.
double kernel(Reconstruction reconstruction, double x) {
    switch (reconstruction) {
    case Reconstruction::Box:
        return 1;
    case Reconstruction::Tent:
        return 1 - std::abs(x);
    case Reconstruction::Gaussian:
        return std::exp(-0.5 * 9 * x * x);
    case Reconstruction::CatmullRom:
        return mitchellNetravali(2 * x, 0, 0.5);
    case Reconstruction::MitchellNetravali:
        return mitchellNetravali(2 * x, 1.0 / 3, 1.0 / 3);
    case Reconstruction::BSpline:
        break;
    }
    return cubicBSpline(2 * x);
}

} // namespace

double mitchellNetravali(double x, double b, double c) {
    x = std::abs(x);
    if (x < 1) {
        return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
    }
    if (x < 2) {
        return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b +
                24 * c) /
               6;
    }
    return 0;
}

double cubicBSpline(double x) { return mitchellNetravali(x, 1, 0); }

std::vector<float> reconstructionWeights(Reconstruction reconstruction, int width) {
    width = std::max(width, 4);
    const int half = (width + 1) / 2;
    const double reach = 0.5 * width;
    std::vector<double> values(2 * std::size_t(half));
    for (int n = -half; n < half; ++n) {
        // A sub-sample that the support covers in part counts with the middle of that part.
        const double lo = std::max(double(n), -reach);
        const double hi = std::min(n + 1.0, reach);
        values[std::size_t(n + half)] = (hi - lo) * kernel(reconstruction, 0.5 * (lo + hi) / reach);
    }
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    std::vector<float> weights;
    for (const double value : values) {
        weights.push_back(float(value / sum));
    }
    return weights;
}

} // namespace vs::sculpt
