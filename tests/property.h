// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace vs::test {

// A number from 0 to n - 1, each as likely as the others; it shrinks towards 0.
inline rc::Gen<int> below(int n) { return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, n)); }

// A number from `lo` to `hi` in hundred steps, which shrinks towards `lo`.
inline rc::Gen<double> between(double lo, double hi) {
    return rc::gen::map(below(101), [lo, hi](int step) { return lo + (hi - lo) * step / 100; });
}

inline rc::Gen<bool> coin() {
    return rc::gen::map(below(2), [](int side) { return side == 1; });
}

// From none to `most` of what `element` gives, each number as likely; it shrinks by leaving some out.
template <typename T>
rc::Gen<std::vector<T>> upTo(int most, rc::Gen<T> element) {
    return rc::gen::resize(most, rc::gen::container<std::vector<T>>(std::move(element)));
}

// Checks a property: a function that draws its input by its parameters or by `*generator` and says by
// RC_ASSERT what must hold. (RC_ASSERT takes its expression apart: with && or || in it, it needs parentheses
// of its own, or both sides are evaluated.) What fails is shrunk to the smallest input that still fails, and
// the test prints it with the line that reproduces it. The inputs are the same in each run, so that a failure
// is the change's and not the day's; RC_PARAMS="seed=5 max_success=1000" in the environment tries others.
template <typename Property>
void checkProperty(int cases, Property&& property) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(info->test_suite_name()) + "." + info->name();
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    if (std::getenv("RC_PARAMS") == nullptr) {
        params.seed = 1;
        params.maxSuccess = cases;
    }
    const auto result = rc::detail::checkTestable(std::forward<Property>(property),
                                                  rc::detail::TestMetadata{name, name}, params);
    if (!result.template is<rc::detail::SuccessResult>()) {
        std::ostringstream said;
        rc::detail::printResultMessage(result, said);
        FAIL() << said.str() << "\nseed: " << params.seed;
    }
}

} // namespace vs::test
