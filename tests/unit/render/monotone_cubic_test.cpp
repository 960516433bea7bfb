// SPDX-License-Identifier: Apache-2.0
#include "render/camera/monotone_cubic.h"

#include "property.h"

#include <array>
#include <cmath>
#include <vector>

namespace vs::render {
namespace {

// Values at increasing times, some neighbours equal.
struct Keys {
    std::vector<double> times;
    std::vector<double> values;
    Ends ends = Ends::Rest;

    [[nodiscard]] double at(double t) const { return monotoneCubic(times, values, t, ends); }
    [[nodiscard]] double secant(std::size_t n) const {
        return (values[n + 1] - values[n]) / (times[n + 1] - times[n]);
    }
};

Keys anyKeys() {
    Keys keys;
    keys.ends = std::array{Ends::Rest, Ends::Run, Ends::Loop}[std::size_t(*test::below(3))];
    double time = *test::between(-5, 5);
    double value = *test::between(-100, 100);
    const int count = 2 + *test::below(6);
    for (int n = 0; n < count; ++n) {
        keys.times.push_back(time);
        keys.values.push_back(value);
        time += *test::between(0.05, 4);
        value = *test::below(4) == 0 ? value : *test::between(-100, 100);
    }
    return keys;
}

TEST(MonotoneCubic, PassesThroughTheKeysToTheBit) {
    test::checkProperty(500, [] {
        const Keys keys = anyKeys();
        for (std::size_t n = 0; n < keys.times.size(); ++n) {
            RC_ASSERT(keys.at(keys.times[n]) == keys.values[n]);
        }
        RC_ASSERT(keys.at(keys.times.front() - 1) == keys.values.front());
        RC_ASSERT(keys.at(keys.times.back() + 1) == keys.values.back());
    });
}

TEST(MonotoneCubic, GoesSteadilyFromKeyToKey) {
    test::checkProperty(500, [] {
        const Keys keys = anyKeys();
        for (std::size_t n = 0; n + 1 < keys.times.size(); ++n) {
            const double way = keys.values[n + 1] - keys.values[n];
            double before = keys.values[n];
            for (int part = 1; part <= 50; ++part) {
                const double t = keys.times[n] + (keys.times[n + 1] - keys.times[n]) * part / 50;
                const double value = keys.at(std::min(t, keys.times[n + 1])); // rounding must not lead beyond
                RC_ASSERT((value - before) * (way < 0 ? -1 : 1) >= -1e-12 * 100); // rounding of values to 100
                RC_ASSERT(way != 0 || value == before);
                before = value;
            }
        }
    });
}

// Finite differences on both sides of a key differ by no more than what the curve bends within them: a cubic
// whose speeds at both ends are at most three secants bends by at most 24 secants a stretch.
TEST(MonotoneCubic, ItsSpeedHasNoJumps) {
    test::checkProperty(500, [] {
        const Keys keys = anyKeys();
        constexpr double h = 1e-5;
        const std::size_t last = keys.times.size() - 1;
        for (std::size_t n = 0; n <= last; ++n) {
            const std::size_t after = n < last ? n : 0; // across the seam of a loop
            const std::size_t before = n > 0 ? n - 1 : last - 1;
            const double bend =
                24 * std::max(std::abs(keys.secant(after)) / (keys.times[after + 1] - keys.times[after]),
                              std::abs(keys.secant(before)) / (keys.times[before + 1] - keys.times[before]));
            const double later = (keys.at(keys.times[after] + h) - keys.values[after]) / h;
            const double earlier = (keys.values[before + 1] - keys.at(keys.times[before + 1] - h)) / h;
            const double allowed = bend * h + 1e-13 * 100 / h; // and rounding of values up to 100
            if ((n > 0 && n < last) || keys.ends == Ends::Loop) {
                RC_ASSERT(std::abs(later - earlier) <= allowed);
            } else if (keys.ends == Ends::Rest) {
                RC_ASSERT(std::abs(n == 0 ? later : earlier) <= allowed);
            }
        }
    });
}

TEST(MonotoneCubic, EvenlySpreadKeysGiveAStraightLine) {
    test::checkProperty(300, [] {
        Keys keys{{}, {}, *test::coin() ? Ends::Run : Ends::Loop};
        const double speed = *test::between(-20, 20);
        const int count = 2 + *test::below(5);
        double time = 0;
        for (int n = 0; n < count; ++n, time += *test::between(0.1, 3)) {
            keys.times.push_back(time);
            keys.values.push_back(7 + speed * time);
        }
        for (int part = 0; part <= 100; ++part) {
            const double t = keys.times.back() * part / 100;
            RC_ASSERT(std::abs(keys.at(t) - (7 + speed * t)) < 1e-11);
        }
    });
}

// Keys on a smooth motion that are close enough give back what lies between them.
TEST(MonotoneCubic, ComesCloseToSmoothMotion) {
    Keys keys{{}, {}, Ends::Run};
    for (int n = 0; n <= 20; ++n) {
        keys.times.push_back(0.1 * n);
        keys.values.push_back(std::exp(0.1 * n));
    }
    for (double t = 0; t <= 2; t += 0.013) {
        EXPECT_NEAR(keys.at(t) / std::exp(t), 1, 3e-4) << t; // a parabola's speed is off by a step's square
    }
}

TEST(MonotoneCubic, OneKeyIsAlwaysThere) {
    const Keys keys{{3}, {5}};
    EXPECT_EQ(keys.at(0), 5);
    EXPECT_EQ(keys.at(3), 5);
    EXPECT_EQ(keys.at(9), 5);
}

} // namespace
} // namespace vs::render
