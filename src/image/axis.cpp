// SPDX-License-Identifier: Apache-2.0
#include "image/axis.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vs::image {

namespace {

// Smallest 1, 2, 2.5 or 5 times a power of ten that is not below x.
double roundUp(double x) {
    const double decade = std::pow(10.0, std::floor(std::log10(x)));
    for (const double times : {1.0, 2.0, 2.5, 5.0}) {
        if (times * decade >= x * (1 - 1e-9)) {
            return times * decade;
        }
    }
    return 10 * decade;
}

} // namespace

std::vector<double> roundTicks(const Range& range, int most) {
    if (!(range.width() > 0) || most < 2) {
        return {};
    }
    // Rounding must not lose a tick that lies on an end.
    const double slack = 1e-9 * range.width();
    for (double step = roundUp(range.width() / most);; step = roundUp(step * 1.01)) {
        const double first = std::ceil((range.lo - slack) / step);
        const double last = std::floor((range.hi + slack) / step);
        if (last - first + 1 > most) {
            continue;
        }
        std::vector<double> ticks;
        for (double i = first; i <= last; ++i) {
            ticks.push_back(i * step + 0.0); // never -0
        }
        return ticks;
    }
}

std::vector<double> decadeTicks(const Range& range, int most) {
    const int first = int(std::ceil(std::log10(range.lo) - 1e-9));
    const int last = int(std::floor(std::log10(range.hi) + 1e-9));
    const int step = std::max(1, (last - first + most) / std::max(1, most));
    std::vector<double> ticks;
    for (int exponent = first; exponent <= last; exponent += step) {
        ticks.push_back(std::pow(10.0, exponent));
    }
    return ticks;
}

std::string tickLabel(double value) {
    std::string digits = fmt::format("{:.10g}", std::abs(value));
    const std::size_t point = std::min(digits.find_first_of(".e"), digits.size());
    for (std::size_t place = point; point > 4 && place > 3;) {
        place -= 3;
        digits.insert(place, "\u2009");
    }
    return (value < 0 ? "\u2212" : "") + digits;
}

std::string decadeLabel(double value) {
    constexpr std::array<const char*, 10> kSuperscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const int exponent = int(std::lround(std::log10(value)));
    if (exponent >= 0 && exponent < 3) {
        return fmt::format("{}", std::lround(value));
    }
    std::string text = "10";
    for (const char digit : fmt::format("{}", exponent)) {
        text += digit == '-' ? "⁻" : kSuperscripts[std::size_t(digit - '0')];
    }
    return text;
}

} // namespace vs::image
