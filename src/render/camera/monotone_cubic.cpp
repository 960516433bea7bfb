// SPDX-License-Identifier: Apache-2.0
#include "render/camera/monotone_cubic.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vs::render {

namespace {

// The speed where two stretches meet: that of the parabola through their three keys, or none where the motion
// turns back or rests.
double speedBetween(double stepBefore, double secantBefore, double stepAfter, double secantAfter) {
    if (secantBefore * secantAfter <= 0) {
        return 0;
    }
    return (stepAfter * secantBefore + stepBefore * secantAfter) / (stepBefore + stepAfter);
}

// The speed at one of two keys at the ends: that of the parabola through the nearest three keys, as far as
// it goes the way of the nearest stretch.
double speedAtEnd(double step, double secant, double nextStep, double nextSecant) {
    const double speed = secant + (secant - nextSecant) * step / (step + nextStep);
    return speed * secant <= 0 ? 0 : speed;
}

void setEnds(std::vector<double>& speeds, const std::vector<double>& steps,
             const std::vector<double>& secants, Ends ends) {
    const std::size_t last = secants.size() - 1;
    if (ends == Ends::Loop) {
        speeds.front() = speeds.back() = speedBetween(steps[last], secants[last], steps[0], secants[0]);
    } else if (ends == Ends::Run) {
        const std::size_t second = std::min<std::size_t>(1, last);
        const std::size_t before = last - second;
        speeds.front() = speedAtEnd(steps[0], secants[0], steps[second], secants[second]);
        speeds.back() = speedAtEnd(steps[last], secants[last], steps[before], secants[before]);
    }
}

// Slows down where the curve of a stretch would leave the values at its ends: where the speeds there, as
// multiples of the secant's, lie outside a circle with the radius 3 (Fritsch and Carlson 1980). A speed that
// two stretches share is only made less by either, which keeps the other within its circle.
void slowDown(std::vector<double>& speeds, const std::vector<double>& secants, Ends ends) {
    for (std::size_t n = 0; n < secants.size(); ++n) {
        if (secants[n] == 0) {
            speeds[n] = speeds[n + 1] = 0;
            continue;
        }
        const double most = 3 * std::abs(secants[n]);
        const double length = std::hypot(speeds[n], speeds[n + 1]);
        if (length > most) {
            speeds[n] *= most / length;
            speeds[n + 1] *= most / length;
        }
    }
    if (ends == Ends::Loop) { // one key seen from both sides
        const bool isFirstLess = std::abs(speeds.front()) < std::abs(speeds.back());
        speeds.front() = speeds.back() = isFirstLess ? speeds.front() : speeds.back();
    }
}

// Speeds at the keys, in values per time.
std::vector<double> keySpeeds(std::span<const double> times, std::span<const double> values, Ends ends) {
    std::vector<double> steps;
    std::vector<double> secants;
    for (std::size_t n = 1; n < times.size(); ++n) {
        steps.push_back(times[n] - times[n - 1]);
        secants.push_back((values[n] - values[n - 1]) / steps.back());
    }
    std::vector<double> speeds(times.size(), 0);
    for (std::size_t n = 1; n < secants.size(); ++n) {
        speeds[n] = speedBetween(steps[n - 1], secants[n - 1], steps[n], secants[n]);
    }
    setEnds(speeds, steps, secants, ends);
    slowDown(speeds, secants, ends);
    return speeds;
}

} // namespace

double monotoneCubic(std::span<const double> times, std::span<const double> values, double t, Ends ends) {
    VS_CHECK(!times.empty());
    VS_CHECK_EQ(times.size(), values.size());
    VS_CHECK(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end());
    // A time that is no number is after nothing.
    if (!(t > times.front())) {
        return values.front();
    }
    if (t >= times.back()) {
        return values.back();
    }
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    const std::size_t n = std::size_t(after - times.begin()) - 1;
    const std::vector<double> speeds = keySpeeds(times, values, ends);
    const double step = times[n + 1] - times[n];
    const double s = (t - times[n]) / step;
    // Hermite's cubic, from the first value on, so that equal values stay exactly what they are.
    const double rise = (values[n + 1] - values[n]) * s * s * (3 - 2 * s);
    const double value = values[n] + rise + step * s * (1 - s) * (speeds[n] * (1 - s) - speeds[n + 1] * s);
    const auto [least, most] = std::minmax(values[n], values[n + 1]);
    return std::clamp(value, least, most); // rounding must not leave them either
}

} // namespace vs::render
